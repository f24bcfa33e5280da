// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/input/dynamics/dynamics_readers.h>
#include <fuga/input/entries/parameter_entries.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Check that the bodies have what they need in order to move and to come to rest. */
    void
    check_motion(const ParameterValues &values,
                 const ParameterSection &solver,
                 const AnyEntry &choice,
                 const ModelDefinition &model)
    {
      const DynamicsDefinition &dynamics = model.dynamics;
      const DynamicsEntries &e           = entries_of<DynamicsEntries>();
      const BodyEntries &body            = entries_of<BodyEntries>();
      const ParameterSection section     = values.section<DynamicsEntries>();
      const auto is_missing              = [&](const AnyEntry &entry, const std::string &why) {
        solver.fail(choice,
                    fmt::format("'{}/{}' is missing: {}. {}",
                                e.name,
                                entry.name(),
                                why,
                                entry.declaration->documentation));
      };
      if (std::none_of(model.materials.begin(), model.materials.end(), [&](const Material &one) {
            return one.weight_density > 0. && !dynamics.is_massless(one.body);
          }))
        solver.fail(choice,
                    fmt::format("no body has inertia. Give those that may move their '{}' (section "
                                "{}).",
                                body.weight_density.name(),
                                body.name));
      if (dynamics.time_step == 0.)
        is_missing(e.time_step, "the motion goes on in steps of time");
      if (dynamics.damping_ratio == 0.)
        is_missing(e.damping_ratio,
                   "without damping elastic bodies go on swinging, and never come to rest");
      StageDefinition longest;
      longest.duration = dynamics.longest_continuation;
      const double n   = number_of_time_steps(dynamics, longest);
      if (!(n <= largest_number_of_steps))
        section.fail(e.longest_continuation,
                     fmt::format("with steps of {:g} s that are {:.3g} of them; {:g} are the most "
                                 "that are allowed. Correct it, or 'Time step' ({}).",
                                 dynamics.time_step,
                                 n,
                                 largest_number_of_steps,
                                 section.origin(e.time_step)));
      if (!dynamics.absorbing.names.empty() && !has_dynamic_stage(model))
        section.fail(e.absorbing,
                     "no stage has a Duration: beyond a limit load supports hold, and nothing "
                     "absorbs. Remove this entry.");
    }
  } // namespace


  void
  check_continuation(const ParameterValues &values, const Parameters &parameters)
  {
    const SolverEntries &e        = entries_of<SolverEntries>();
    const ParameterSection solver = values.section<SolverEntries>();
    const auto refuse             = [&](const bool is_chosen, const AnyEntry &entry) {
      if (is_chosen)
        solver.fail(e.beyond_limit,
                    fmt::format("'{} = {}' ({}) is for slow loads only. Remove one of the two.",
                                entry.name(),
                                solver.text(entry),
                                solver.origin(entry)));
    };
    values.attempt(solver, [&]() {
      refuse(!parameters.solver.follow_events, e.follow);
      refuse(parameters.model.body_solver == BodySolver::matrix_free, e.bodies);
      if (parameters.of_sweep)
        solver.fail(
          e.beyond_limit,
          "the variants of a sweep end where they lose equilibrium. Remove this entry, or "
          "the section Sweep.");
      check_motion(values, solver, e.beyond_limit, parameters.model);
    });
  }
} // namespace fuga
