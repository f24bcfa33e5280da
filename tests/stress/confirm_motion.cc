// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/confirm_motion.h"

#include "judges/from_contact.h"
#include "judges/linear_solve.h"
#include "stress/cone_examiner.h"
#include "stress/examiner.h"

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/contact/dynamics/step_system.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/run/model/phase_run.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fuga::stress
{
  namespace
  {
    /** Seconds for which an interruption comes before. */
    constexpr double to_the_end = 3600.;

    /**
     * Elements and a state of theirs as a step of time sees them: jumps count from its beginning.
     * What is left of the @p largest jumps that there have been is rounding, and no measure of
     * lengths: where a joint sticks nothing moves.
     */
    class StepView
    {
    public:
      StepView(const StepSystem &step,
               const LoadHistory &history,
               const double part,
               const double largest)
        : jumps_before(multiply(step.imposed_jumps(), history.factors(part)))
        , rounding(1e-13 * largest)
      {
      }

      std::vector<ContactElement>
      elements(std::vector<ContactElement> result) const
      {
        for (ContactElement &element : result)
          element.initial_gap = moved(element.initial_gap + jumps_before[element.normal_bar]);
        return result;
      }

      JointState
      state(const std::vector<ContactElement> &elements, JointState result) const
      {
        result.dislocations = since_beginning(std::move(result.dislocations));
        for (std::size_t k = 0; k < elements.size(); ++k)
          if (elements[k].has_tangential_bar())
            result.slips[k][0] =
              moved(result.slips[k][0] - jumps_before[elements[k].tangential_bar]);
        return result;
      }

      Vector
      since_beginning(Vector jumps) const
      {
        for (std::size_t bar = 0; bar < jumps.size(); ++bar)
          jumps[bar] = moved(jumps[bar] - jumps_before[bar]);
        return jumps;
      }

    private:
      double
      moved(const double way) const
      {
        return std::abs(way) <= rounding ? 0. : way;
      }

      const Vector jumps_before;
      const double rounding;
    };

    struct Piece
    {
      const std::vector<ContactElement> &elements;
      const StepSystem &step;
      const LoadHistory &history;
      const JointState &from, &to;
      /** Of the jumps in the motion so far. */
      double largest_jump;
    };

    /** x with B x = jumps, counted from the beginning of the step, or of S x + Bᵀ p = f; nothing if
     * that has no digits. */
    std::optional<Vector>
    coordinates(const judges::JudgeProblem &at,
                const StepView &view,
                const Piece &piece,
                Vector load)
    {
      if (at.B.size() == 0)
        return view.since_beginning(
          piece.step.layered().jumps(piece.to.dislocations, piece.to.forces));
      for (std::size_t i = 0; i < load.size(); ++i)
        for (std::size_t bar = 0; bar < piece.to.forces.size(); ++bar)
          load[i] -= at.jump_operator(bar, i) * piece.to.forces[bar];
      const judges::LinearSolution solution = judges::solve_linear(at.S, load);
      if (!solution.regular)
        return {};
      return Vector(solution.X.col(0).data(), solution.X.col(0).data() + load.size());
    }

    /** Nothing if x has no digits. */
    std::optional<StepReport>
    examine_in_the_plane(const Piece &piece)
    {
      const StepView view(piece.step, piece.history, piece.to.part_of_step, piece.largest_jump);
      const auto elements   = view.elements(piece.elements);
      const JointState from = view.state(elements, piece.from), to = view.state(elements, piece.to);
      const judges::JudgeProblem at = problem_in(judges::judge_problem(piece.step, elements), from);
      const auto load               = [&](const double t) {
        return judges::judge_load(piece.step, piece.history.factors(t));
      };
      const auto x = coordinates(at, view, piece, load(to.part_of_step));
      if (!x)
        return {};
      judges::StepSolution ours;
      ours.x              = *x;
      ours.forces         = to.forces;
      ours.slip           = judges::judge_slips(to);
      ours.states         = to.states;
      const Vector before = judges::judge_slips(from);
      complete(at, before, load(to.part_of_step), ours);
      StepReport report;
      report.residual = ours.residual;
      if (const auto other = solve_anew(at, before, load(from.part_of_step), load(to.part_of_step)))
        report.distance = distance(*other, ours);
      return report;
    }

    StepReport
    examine_in_space(const Piece &piece)
    {
      const StepView view(piece.step, piece.history, piece.to.part_of_step, piece.largest_jump);
      const auto elements   = view.elements(piece.elements);
      const JointState from = view.state(elements, piece.from);
      const judges::ConeNewton newton(piece.step.stiffness(),
                                      tests::dense(piece.step.jump_operator()),
                                      piece.step.load_patterns(),
                                      cones_of(elements, from));
      return examine_cone_step(newton,
                               cone_state(elements, from),
                               piece.history.factors(piece.from.part_of_step),
                               cone_state(elements, view.state(elements, piece.to)),
                               piece.history.factors(piece.to.part_of_step));
    }

    template <int dim>
    class MotionWitness : public PathObserver
    {
    public:
      /** @p examines: whether pieces are put before the independent solvers. */
      MotionWitness(const double seconds, const bool examines)
        : is_examined(examines)
        , end(Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)))
      {
      }

      Confirmation confirmation;
      JointState last_state;
      std::size_t levels = 0;

      void
      begin(PhaseRun<dim> &next)
      {
        phase     = &next;
        can_solve = is_examined && (dim == 3 ? cones_know_layers(phase->joint.elements)
                                             : judges_know_layers(phase->joint.elements));
        levels    = 0;
        step      = nullptr;
      }

      /** A run has followed the motion to its end; here it is followed for as long as it is
       * examined. */
      bool
      wants_more() const override
      {
        return Clock::now() < end;
      }

      void
      advanced(const PathPoint &from, const PathPoint &to, const double length) override
      {
        phase->judge.follow(from, to, length);
        last_state   = to.state;
        largest_jump = std::max(largest_jump, max_abs(to.state.dislocations));
        if (step != nullptr && can_solve &&
            judges_know_strengths(phase->joint.elements, from.state))
          examine({phase->joint.elements, *step, *history, from.state, to.state, largest_jump});
      }

      void
      jumped(const JointState &to) override
      {
        phase->judge.lose_track();
        last_state = to;
      }

      void
      changed(const std::vector<ContactEvent> &, const JointState &state) override
      {
        last_state = state;
        phase->judge.judge(state);
      }

      void
      reached(const std::size_t index, const JointState &state) override
      {
        last_state = state;
        levels     = index + 1;
        phase->judge.judge(state);
      }

      void
      began_step(const ContactSystem &system, const LoadHistory &history_of_step) override
      {
        phase->began_step(system, history_of_step);
        step    = &dynamic_cast<const StepSystem &>(system);
        history = &history_of_step;
      }

      void
      ended_step(const JointState &state) override
      {
        last_state = state;
        phase->ended_step(state);
      }

    private:
      using Clock = std::chrono::steady_clock;

      // Nothing acts: rounding is all there is to compare.
      static bool
      is_in_flight(const Piece &piece)
      {
        constexpr double no_force = 1e-9;
        const Vector load =
          judges::judge_load(piece.step, piece.history.factors(piece.to.part_of_step));
        return max_abs(load) <= no_force * piece.step.force_scale() &&
               max_abs(piece.to.forces) <= no_force * piece.step.force_scale();
      }

      // Steps that follow each other are alike.
      void
      examine(const Piece &piece)
      {
        constexpr std::size_t every = 5;
        if (n_seen++ % every != 0 || is_in_flight(piece))
          return;
        const std::optional<StepReport> report =
          dim == 2 ? examine_in_the_plane(piece) : examine_in_space(piece);
        if (report)
          count_piece(*report, piece.to.t, confirmation);
      }

      const bool is_examined;
      const Clock::time_point end;
      PhaseRun<dim> *phase       = nullptr;
      const StepSystem *step     = nullptr;
      const LoadHistory *history = nullptr;
      bool can_solve             = false;
      std::size_t n_seen         = 0;
      double largest_jump        = 0.;
    };
  } // namespace

  template <int dim>
  Confirmation
  confirm_motion(const Parameters &parameters, const std::string &verdict, const double seconds)
  {
    const bool has_failed = verdict == "numerical failure";
    MotionWitness<dim> witness(has_failed ? to_the_end : seconds, !has_failed);
    Confirmation &confirmation = witness.confirmation;
    auto model                 = std::make_unique<const Model<dim>>(parameters);
    auto phase                 = std::make_unique<PhaseRun<dim>>(*model, parameters);
    if (!has_failed && !judges_know_layers(phase->joint.elements))
      {
        confirmation.by = "certificate";
        return confirmation;
      }
    witness.begin(*phase);
    std::string found = "numerical failure";
    try
      {
        PathResult result = phase->path->run(model->loads.levels, witness);
        while (result.verdict == Verdict::done && !model->is_last_phase() && witness.wants_more())
          {
            const PhaseEnd end = phase->leave(witness.last_state, result, witness.levels);
            phase.reset();
            model                  = std::make_unique<const Model<dim>>(parameters, end, nullptr);
            phase                  = std::make_unique<PhaseRun<dim>>(*model, parameters);
            const Checkpoint start = phase->enter(end);
            witness.begin(*phase);
            result = phase->path->go_on(start.cut, model->loads.levels, witness);
          }
        prove_limit(
          phase->judge, phase->joint.elements, phase->layered, witness.last_state, result);
        found = verdict_name(result.verdict);
      }
    catch (const LawExhausted &limit)
      {
        if (law_is_exhausted(phase->joint.elements, limit.state))
          confirmation.by = "limit of the law";
      }
    catch (const NumericalFailure &)
      {
      }
    catch (const Interrupted &)
      {
        found = verdict; // what was followed is examined
      }
    if (witness.wants_more() && verdict != "interrupted" && found != verdict)
      confirmation.objection += "the verdict is another one when the path is run again; ";
    if (has_failed && confirmation.by.empty() && confirmation.objection.empty())
      confirmation.objection = verdict;
    if (confirmation.by.empty() && confirmation.objection.empty())
      confirmation.by = confirmation_by_pieces(confirmation);
    return confirmation;
  }

  template Confirmation
  confirm_motion<2>(const Parameters &, const std::string &, const double);
  template Confirmation
  confirm_motion<3>(const Parameters &, const std::string &, const double);
} // namespace fuga::stress
