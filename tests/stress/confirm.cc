// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/confirm.h"

#include "stress/examiner.h"

#include <fuga/contact/element/layer_response.h>

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace fuga::stress
{
  void
  PieceSample::advanced(const PathPoint &from, const PathPoint &to, const double)
  {
    end = to.state;
    if (to.state.t - from.state.t < 1e-9)
      return; // nothing to solve again
    last.emplace(Piece{from.state, to.state});
    ++n_seen;
    if (pieces.size() < capacity)
      pieces.push_back(*last);
    else if (n_seen % 7 == 0)
      pieces[(n_seen / 7) % capacity] = *last;
  }

  void
  PieceSample::jumped(const JointState &to)
  {
    end = to;
  }

  void
  PieceSample::changed(const std::vector<ContactEvent> &, const JointState &state)
  {
    end = state;
  }

  void
  PieceSample::reached(const std::size_t, const JointState &state)
  {
    end = state;
    levels.push_back(state);
  }

  bool
  law_is_exhausted(const std::vector<ContactElement> &elements, const JointState &state)
  {
    return !state.states.empty() &&
           std::any_of(elements.begin(), elements.end(), [&](const ContactElement &element) {
             const double pressure = -state.forces[element.normal_bar] / element.area;
             if (element.coupling == nullptr)
               return element.normal_law != nullptr &&
                      std::isfinite(element.normal_law->deformation_limit()) &&
                      pressure > element.normal_law->stress(
                                   (1. - 1e-12) * element.normal_law->deformation_limit());
             const double limit = element.coupling->closure_limit();
             const auto layer   = element.coupling->deformation(
               pressure, length(shear_part(element, state.forces)) / element.area);
             return layer.closure >= (1. - 1e-6) * limit;
           });
  }

  void
  count_piece(const StepReport &report, const double t, Confirmation &confirmation)
  {
    /** Two solutions this close are the same one. */
    constexpr double same = 1e-6;
    /** A state with a larger residual does not satisfy the conditions. */
    constexpr double right = 1e-8;
    if (report.distance && *report.distance <= same)
      {
        ++confirmation.n_equal;
        confirmation.difference = std::max(confirmation.difference, *report.distance);
      }
    else if (report.residual <= right)
      ++confirmation.n_other;
    else
      confirmation.objection += fmt::format(
        "step to t = {:.9g}: residual {:.1e}, other solver {}; ",
        t,
        report.residual,
        report.distance ? fmt::format("at distance {:.1e}", *report.distance) : "without solution");
  }

  std::string
  confirmation_by_pieces(const Confirmation &confirmation)
  {
    return confirmation.n_other == 0 && confirmation.n_equal > 0 ? "solved again"
           : confirmation.n_equal > 0                            ? "solved again, residual"
           : confirmation.n_other > 0                            ? "residual"
                                                                 : "certificate";
  }

  JointState
  virgin_state(const JointModel &joint)
  {
    JointState state;
    std::size_t n_bars = 0;
    for (const ContactElement &element : joint.elements)
      {
        n_bars += 1 + element.has_tangential_bar() + element.has_second_tangential_bar();
        const bool open = element.initial_gap > 0.;
        state.states.push_back(open ? ContactState::open : ContactState::stick);
        state.strengths.push_back(virgin_strength(element.friction, element.area));
        if (open) // lips that never touched have no bond
          state.strengths.back().cohesion = state.strengths.back().tension = 0.;
      }
    state.unreleased.assign(n_bars, 0.);
    state.dilations.assign(joint.elements.size(), 0.);
    state.forces.assign(n_bars, 0.);
    state.dislocations.assign(n_bars, 0.);
    state.slips.assign(joint.elements.size(), {{0., 0.}});
    return state;
  }

  JointState
  end_of(const PieceSample &sample, const JointModel &joint)
  {
    return sample.end.states.empty() ? virgin_state(joint) : sample.end;
  }

  namespace
  {
    void
    check_piece(const Examiner &examiner,
                const PieceSample::Piece &piece,
                Confirmation &confirmation)
    {
      count_piece(examiner.examine_step(piece.from, piece.to), piece.to.t, confirmation);
    }

    void
    confirm_end(const Examiner &examiner,
                const PathResult &result,
                const JointState &end,
                Confirmation &confirmation)
    {
      const bool searched     = examiner.can_continue(end);
      const RateSearch search = searched ? examiner.search(end) : RateSearch();
      std::string by;
      switch (search.answer)
        {
          case RateAnswer::continuation:
            // Along a curved strength the load may have a maximum, up to which there are rates.
            if (examiner.is_turning_point(end))
              by = "no implicit step";
            else
              confirmation.objection +=
                fmt::format("the path can go on: {} boundary elements, {} schemes; ",
                            search.n_boundary,
                            search.n_schemes);
            break;
          case RateAnswer::none:
            by = "enumeration";
            break;
          case RateAnswer::ray:
            by = "Lemke ray";
            break;
          case RateAnswer::undecided:
            break;
        }
      // A body that falls moves freely as well, until it comes to rest.
      const bool mechanism =
        !result.mechanism_jumps.empty() && examiner.is_mechanism(end, result.mechanism_jumps);
      // A complete enumeration needs no further witness; nor does a mechanism: a finite step may
      // find a place for a body that nothing holds and nothing drives.
      const bool asks_steps =
        search.answer != RateAnswer::none && !mechanism && examiner.can_solve(end);
      if (asks_steps && examiner.finds_step_beyond(end, 1e-6))
        confirmation.objection += "an implicit step of 1e-6 goes on; ";
      if (mechanism)
        by += by.empty() ? "mechanism" : ", mechanism";
      if (by.empty() && !searched)
        by = "certificate"; // laws or strengths that no independent solver knows
      // Where others move freely the rates have no solution that is unique: only steps are left.
      if (confirmation.objection.empty() && by.empty() && asks_steps &&
          !examiner.finds_step_beyond(end, 1e-5) && !examiner.finds_step_beyond(end, 1e-4))
        by = "no implicit step";
      if (confirmation.objection.empty() && by.empty())
        confirmation.objection = "no independent solver could decide; ";
      if (confirmation.objection.empty())
        confirmation.by = by;
    }
  } // namespace

  Confirmation
  confirm(const Model<2> &model,
          const JointModel &joint,
          const PathResult &result,
          const PieceSample &sample,
          const double seconds)
  {
    using Clock      = std::chrono::steady_clock;
    const auto start = Clock::now();
    Confirmation confirmation;
    const Examiner examiner(model, joint);
    if (sample.last && examiner.can_solve(sample.last->from))
      check_piece(examiner, *sample.last, confirmation);
    for (const PieceSample::Piece &piece : sample.pieces)
      if (examiner.can_solve(piece.from) &&
          std::chrono::duration<double>(Clock::now() - start).count() < seconds)
        check_piece(examiner, piece, confirmation);
    if (result.verdict != Verdict::done)
      confirm_end(examiner, result, end_of(sample, joint), confirmation);
    else if (confirmation.objection.empty())
      confirmation.by = confirmation_by_pieces(confirmation);
    return confirmation;
  }
} // namespace fuga::stress
