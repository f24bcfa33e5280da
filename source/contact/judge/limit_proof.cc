// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/virgin_state.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    std::string
    figures(const MechanismCertificate &proof)
    {
      return fmt::format(
        "resistance {:.2g}, inadmissible part {:.2g}, balance of power {:.2g} (all "
        "should vanish), drive {:.2g} (should be positive)",
        proof.resistance,
        proof.inadmissible,
        proof.balance,
        proof.drive);
    }

    std::string
    figures(const BarrierCertificate &proof)
    {
      return fmt::format("equilibrium {:.2g}, inadmissible part {:.2g} (both should vanish), drive "
                         "{:.2g} (should be positive)",
                         proof.equilibrium,
                         proof.inadmissible,
                         proof.drive);
    }

    /** Record that there is no continuation: the motion that was found proves nothing, but the fact
     * that all states were tried does. */
    void
    take_no_continuation(const std::vector<ContactElement> &elements,
                         const JointState &state,
                         PathResult &result)
    {
      constexpr double moves = 1e-6; // of the largest jump
      result.verdict         = Verdict::no_continuation;
      result.mechanism       = MechanismKind::none;
      result.critical.t      = state.t;
      for (std::size_t k = 0; k < elements.size(); ++k)
        for (std::size_t a = 0; a < elements[k].n_bars(); ++a)
          if (std::abs(result.mechanism_jumps[elements[k].bar(a)]) > moves)
            {
              result.critical.elements.push_back(k);
              break;
            }
      result.mechanism_jumps.clear();
    }
  } // namespace

  LimitProof
  prove_limit(const Judge &judge,
              const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const JointState &last_state,
              PathResult &result)
  {
    const bool is_limit = result.verdict == Verdict::limit_load;
    if ((!is_limit && result.verdict != Verdict::no_continuation) ||
        result.beyond.end != BeyondLimit::End::none)
      return {};
    const JointState state =
      last_state.states.empty()
        ? virgin_state(elements, system.n_bars(), system.water_in_joints() != nullptr)
        : last_state;
    MechanismCertificate of_path;
    if (is_limit)
      of_path = judge.judge_mechanism(state, result.mechanism_jumps);
    if (is_limit && of_path.proves())
      return {of_path, {}};

    // What comes to rest again, after a jump, is no limit load.
    if (!is_limit && result.mechanism != MechanismKind::none && result.jump.shows_instability())
      return {};

    const std::optional<Vector> motion = judge.mechanism(state);
    const MechanismCertificate of_judge =
      motion ? judge.judge_mechanism(state, *motion) : MechanismCertificate();
    if (motion && of_judge.proves())
      {
        result.verdict         = Verdict::limit_load;
        result.mechanism_jumps = *motion;
        result.mechanism       = classify_mechanism(*motion, elements);
        result.critical        = {};
        result.tried.clear();
        result.barrier = {};
        return {of_judge, {}};
      }
    if (is_limit && of_path.is_neutral() && result.critical.all_counted)
      {
        take_no_continuation(elements, state, result);
        return {};
      }
    if (!is_limit && result.tried.empty())
      return {};
    const BarrierCertificate barrier = judge.judge_barrier(state, result.barrier);
    if (!is_limit && barrier.proves())
      {
        result.tried.clear();
        return {{}, barrier};
      }
    if (!is_limit && result.jump.shows_instability())
      {
        result.tried.clear();
        return {};
      }
    throw NumericalFailure(fmt::format(
      "{} load time {:.12g}, and no motion proves that there is none. "
      "{}. {}{}. The structure may stand; try softer joints{}.",
      result.jump.found ? "No continuous path was found after" : "No equilibrium was found after",
      state.t,
      is_limit ? "The motion found: " + figures(of_path) : result.tried,
      motion ? "The rigid motion of the bodies that the load drives most: " + figures(of_judge)
             : "The load drives no rigid motion of the bodies that their joints allow",
      result.barrier.forces.empty()
        ? ""
        : ". The virtual motion on which answers of the joints work least: " + figures(barrier),
      result.jump.found
        ? ", or let it jump to the equilibrium found near by (Solver/No continuation = jump)"
        : ""));
  }
} // namespace fuga
