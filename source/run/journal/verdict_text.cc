// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/point_text.h>
#include <fuga/output/tables/summary.h>
#include <fuga/run/journal/verdict_text.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  std::string
  place_text(const double t, const std::vector<std::string> &stage_names, const std::string &more)
  {
    const auto [stage, fraction] = stage_of(t, stage_names.size());
    return fmt::format(
      "{:.9g} of stage '{}' (t = {:.12g}{})", fraction, stage_names[stage], t, more);
  }

  template <int dim>
  std::string
  critical_friction_text(const PhaseRun<dim> &phase, const PathResult &result)
  {
    constexpr std::size_t max_named  = 3;
    const CriticalFriction &critical = result.critical;
    std::string where;
    for (std::size_t i = 0; i < std::min(max_named, critical.elements.size()); ++i)
      {
        const ContactElement &element = phase.joint.elements[critical.elements[i]];
        dealii::Point<dim> place;
        for (unsigned int c = 0; c < dim; ++c)
          place[c] = element.position[c];
        where += fmt::format("{}{} {} at {}",
                             i == 0 ? "" : ", ",
                             phase.model.joint_names[element.joint],
                             element.number,
                             text_of(place));
      }
    if (critical.elements.size() > max_named)
      where += fmt::format(" and {} more", critical.elements.size() - max_named);
    const std::string count = critical.n_branches == 0
                                ? "no continuation"
                                : fmt::format("{}{} continuations",
                                              critical.all_counted ? "" : "at least ",
                                              critical.n_branches);
    return fmt::format("friction beyond its critical value: {}, decided by {}", count, where);
  }

  std::string
  jump_text(const Jump &jump, const Units &units)
  {
    if (!jump.found)
      return "";
    return fmt::format(
      "; a jump of {:.4g} {} leads to an equilibrium near by and sets free {:.4g} {}, "
      "of which friction takes {:.4g} in a slow motion (Solver/No continuation = "
      "jump goes on from there)",
      jump.size,
      units.length,
      jump.released,
      units.energy(),
      jump.dissipated);
  }

  template <int dim>
  std::string
  reason_text(const PhaseRun<dim> &phase, const PathResult &result)
  {
    const std::string reason =
      result.mechanism != MechanismKind::none
        ? "mechanism: " + mechanism_name(result.mechanism)
        : "although nothing moves freely, " + critical_friction_text(phase, result);
    return result.verdict == Verdict::limit_load
             ? reason
             : reason + jump_text(result.jump, phase.parameters.output.units);
  }

  std::string
  continuation_text(const MotionBeyondLimit &continuation, const Units &units)
  {
    const bool was_lost = continuation.loss.verdict != Verdict::done;
    const std::string state =
      continuation.rests
        ? fmt::format("rest at t = {:.12g}", continuation.t)
        : fmt::format("still move with {:.4g} {}/s", continuation.velocity, units.length);
    return fmt::format(
      "bodies that {} at t = {:.12g} {} after {:.4g} s; largest slip "
      "{:.6g} {}, work of the loads {:.4g} {}, of friction {:.4g}, of damping {:.4g}",
      was_lost ? "lost equilibrium" : "moved",
      continuation.loss.t,
      state,
      continuation.duration,
      continuation.slip,
      units.length,
      continuation.energies.work,
      units.energy(),
      continuation.friction,
      continuation.energies.damping);
  }

  template std::string
  critical_friction_text(const PhaseRun<2> &, const PathResult &);
  template std::string
  critical_friction_text(const PhaseRun<3> &, const PathResult &);
  template std::string
  reason_text(const PhaseRun<2> &, const PathResult &);
  template std::string
  reason_text(const PhaseRun<3> &, const PathResult &);
} // namespace fuga
