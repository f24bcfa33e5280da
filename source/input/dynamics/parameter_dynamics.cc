// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/input/dynamics/dynamics_readers.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return the numbers of an entry between ';'. @p form describes how they are written, for
     * messages. */
    std::vector<double>
    read_numbers(const ParameterSection &section,
                 const Text &entry,
                 const std::size_t n,
                 const std::string &form)
    {
      std::vector<double> numbers;
      for (const std::string &piece : split_pieces(section.text(entry), ';'))
        if (const std::optional<double> number = number_of_text(piece))
          numbers.push_back(*number);
        else
          section.fail(
            entry,
            fmt::format("'{}' is not a number. Write '{}', with decimal points.", piece, form));
      if (numbers.size() != n)
        section.fail(
          entry, fmt::format("{} number(s) instead of {}. Write '{}'.", numbers.size(), n, form));
      return numbers;
    }


    void
    read_initial_velocities(const ParameterValues &values, ModelDefinition &model)
    {
      const BodyEntries &e                       = entries_of<BodyEntries>();
      const unsigned int first                   = first_dynamic_stage(model);
      const std::vector<ParameterSection> bodies = values.subsections<BodyEntries>();
      for (std::size_t i = 0; i < bodies.size(); ++i)
        values.attempt(bodies[i], [&]() {
          if (!bodies[i].given(e.initial_velocity))
            return;
          if (!has_dynamic_stage(model))
            bodies[i].fail(
              e.initial_velocity,
              "no stage has a Duration, so that nothing moves by itself. Add the entry "
              "Duration to a stage, or remove this one.");
          if (!is_there(model.materials[i], first))
            bodies[i].fail(e.initial_velocity,
                           fmt::format("the body is not there in stage '{}', the first with a "
                                       "Duration. Remove this entry.",
                                       model.stages[first].name));
          const std::vector<double> velocity =
            read_numbers(bodies[i],
                         e.initial_velocity,
                         model.dimension,
                         model.dimension == 2 ? "vx; vy" : "vx; vy; vz");
          std::copy(velocity.begin(), velocity.end(), model.materials[i].initial_velocity.begin());
        });
    }


    void
    read_gravity(const ParameterSection &section, const Units &units, double &gravity)
    {
      const DynamicsEntries &e = entries_of<DynamicsEntries>();
      if (section.given(e.gravity))
        return;
      const std::optional<double> metres = units.metres();
      if (!metres)
        section.fail(
          fmt::format("'{}' is missing: the unit of length, '{}', is not known, and so g "
                      "is not. {}",
                      e.gravity.name(),
                      units.length,
                      e.gravity.declaration->documentation));
      gravity /= *metres;
    }


    void
    read_massless_bodies(const ParameterSection &section,
                         const std::vector<Material> &materials,
                         DynamicsDefinition &dynamics)
    {
      const DynamicsEntries &e = entries_of<DynamicsEntries>();
      if (!section.given(e.massless_bodies))
        return;
      std::vector<std::string> bodies;
      for (const Material &material : materials)
        bodies.push_back(material.body);
      dynamics.massless_bodies = section.list(e.massless_bodies);
      for (const std::string &body : dynamics.massless_bodies)
        {
          const Material &material =
            materials[number_of(body, bodies, "body", section, e.massless_bodies)];
          const auto &v = material.initial_velocity;
          if (std::any_of(v.begin(), v.end(), [](const double c) { return c != 0.; }))
            section.fail(e.massless_bodies,
                         fmt::format("body '{}' has an 'Initial velocity', which means nothing "
                                     "without mass. Remove one of the two.",
                                     body));
        }
    }


    void
    read_absorbing(const ParameterSection &section, NamedBoundaries &absorbing)
    {
      const DynamicsEntries &e = entries_of<DynamicsEntries>();
      if (section.given(e.absorbing))
        absorbing = {section.list(e.absorbing), section.origin(e.absorbing)};
    }


    void
    read_damping(const ParameterSection &section, DynamicsDefinition &dynamics)
    {
      const DynamicsEntries &e = entries_of<DynamicsEntries>();
      if (!section.given(e.damping_frequencies))
        {
          if (dynamics.damping_ratio > 0.)
            section.fail(e.damping_ratio,
                         fmt::format("'{}' is missing. {}",
                                     e.damping_frequencies.name(),
                                     e.damping_frequencies.declaration->documentation));
          return;
        }
      if (!section.given(e.damping_ratio))
        section.fail(e.damping_frequencies,
                     fmt::format("frequencies without '{}' do nothing. Add the ratio, or remove "
                                 "this entry.",
                                 e.damping_ratio.name()));
      const std::vector<double> f = read_numbers(section, e.damping_frequencies, 2, "f1; f2");
      if (!(f[0] > 0. && f[0] < f[1]))
        section.fail(e.damping_frequencies,
                     "the frequencies must be above 0 and increase, for example '2; 10'.");
      std::copy(f.begin(), f.end(), dynamics.damping_frequencies.begin());
    }


    /** Check the modes, which are those of linear bodies that supports hold. */
    void
    check_modes(const ParameterValues &values, const Parameters &parameters)
    {
      const DynamicsDefinition &dynamics = parameters.model.dynamics;
      const DynamicsEntries &e           = entries_of<DynamicsEntries>();
      const EarthquakeEntries &shaking   = entries_of<EarthquakeEntries>();
      const ParameterSection section     = values.section<DynamicsEntries>();
      if (dynamics.bodies == MotionBodies::finite_elements)
        {
          if (section.given(e.highest_frequency))
            section.fail(
              e.highest_frequency,
              fmt::format("finite elements have no limit of frequency. Add '{} = modes', "
                          "or remove this entry.",
                          e.bodies.name()));
          return;
        }
      const auto refuse = [&](const bool is_chosen, const std::string &what) {
        if (is_chosen)
          section.fail(e.bodies,
                       fmt::format("'{}' needs finite elements: the modes are those of bodies that "
                                   "are held, and do not change. Remove one of the two.",
                                   what));
      };
      refuse(!dynamics.compliant_base.names.empty(), shaking.compliant_base.name());
      refuse(!dynamics.free_field.names.empty(), shaking.free_field.name());
      refuse(!dynamics.absorbing.names.empty(), e.absorbing.name());
      refuse(dynamics.second_order != SecondOrder::none, e.second_order.name());
      for (const JointParameters &joint : parameters.joints)
        if (joint.normal_law == LayerLaw::rigid || joint.shear_law == LayerLaw::rigid)
          section.fail(
            e.bodies,
            fmt::format("the layer of joint '{}' is rigid, whose lips must have no mass, "
                        "but those of modes have. Give it a stiffness, or take finite "
                        "elements.",
                        joint.definition.name));
    }


    void
    check_number_of_steps(const ParameterValues &values, const ModelDefinition &model)
    {
      const DynamicsEntries &e                   = entries_of<DynamicsEntries>();
      const ParameterSection section             = values.section<DynamicsEntries>();
      const std::vector<ParameterSection> stages = values.subsections<StageEntries>();
      for (std::size_t s = 0; s < stages.size(); ++s)
        if (const StageDefinition &stage = model.stages[s]; stage.is_dynamic())
          {
            const Number &duration = entries_of<StageEntries>().duration;
            if (model.dynamics.time_step == 0.)
              stages[s].fail(duration,
                             fmt::format("'{}/{}' is missing, which a stage with a Duration needs. "
                                         "{}",
                                         e.name,
                                         e.time_step.name(),
                                         e.time_step.declaration->documentation));
            const double n = number_of_time_steps(model.dynamics, stage);
            if (!(n <= largest_number_of_steps))
              stages[s].fail(duration,
                             fmt::format("with steps of {:g} s the stage has {:.3g} of them; {:g} "
                                         "are the most that are allowed. Correct it, or 'Time "
                                         "step' ({}).",
                                         model.dynamics.time_step,
                                         n,
                                         largest_number_of_steps,
                                         section.origin(e.time_step)));
          }
    }
  } // namespace


  void
  refuse_without_motion(const ParameterSection &section)
  {
    section.for_given([&section](const AnyEntry &entry) {
      if (entry.declaration->presence == Presence::optional)
        section.fail(entry,
                     "no stage has a Duration, so that loads are slow and this does nothing. Add "
                     "the entry Duration to a stage, or remove this one.");
    });
  }


  void
  read_dynamics(const ParameterValues &values, Parameters &parameters)
  {
    ModelDefinition &model         = parameters.model;
    const ParameterSection section = values.section<DynamicsEntries>();
    read_initial_velocities(values, model);
    values.attempt(section, [&]() {
      if (!may_move(parameters))
        refuse_without_motion(section);
      section.read(model.dynamics);
      if (!may_move(parameters))
        return;
      read_gravity(section, parameters.output.units, model.dynamics.gravity);
      read_massless_bodies(section, model.materials, model.dynamics);
      read_absorbing(section, model.dynamics.absorbing);
      read_damping(section, model.dynamics);
    });
    if (values.is_broken<DynamicsEntries>())
      return;
    values.attempt(values.section<EarthquakeEntries>(),
                   [&]() { read_earthquake(values, parameters); });
    if (values.is_broken<EarthquakeEntries>())
      return;
    values.attempt(section, [&]() { check_modes(values, parameters); });
    check_dynamic_stages(values, parameters);
    check_number_of_steps(values, model);
    if (parameters.solver.beyond_limit == LimitLoadChoice::dynamic)
      check_continuation(values, parameters);
  }
} // namespace fuga
