// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/study/sweep_row.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  namespace
  {
    template <int dim>
    Columns<SweepRow>
    columns_of_joint(const std::size_t j, const Model<dim> &model)
    {
      const Units &u     = model.parameters.output.units;
      const auto columns = [&](const std::string &names) {
        return columns_of<SweepRow>(
          resultant_quantities(u),
          names,
          [j](const SweepRow &row) -> const auto & { return row.resultants[j]; },
          model.joint_names[j] + " ");
      };
      Columns<SweepRow> result = columns(dim == 3 ? "N T T2" : "N T");
      if (has_dynamic_stage(model.parameters.model))
        {
          append(
            result,
            columns(dim == 3 ? "mean_slip mean_slip2 largest_slip" : "mean_slip largest_slip"));
          append(result,
                 {{model.joint_names[j] + " largest_opening", u.length, [j](const SweepRow &row) {
                     return row.largest_openings[j];
                   }}});
        }
      append(result,
             columns("M share_open share_slip largest_pressure sliding_safety overturning_safety "
                     "cracked_length"));
      return result;
    }

    /** Return the methods by which any of the variants looks for a factor of safety. */
    std::vector<std::string>
    methods(const Parameters &parameters)
    {
      std::vector<std::string> names;
      for (const auto &condensation : parameters.condensations)
        for (const StageDefinition &stage : condensation->model.stages)
          if (stage.purpose != StagePurpose::loading &&
              std::find(names.begin(), names.end(), stage.name) == names.end())
            names.push_back(stage.name);
      return names;
    }

    /** Return the columns with the factor and the verdict of one method. */
    Columns<SweepRow>
    columns_of_safety(const std::string &method)
    {
      const auto of_row = [method](const SweepRow &row) {
        const auto found =
          std::find_if(row.safety.begin(), row.safety.end(), [&](const SafetyFactor &safety) {
            return safety.method == method;
          });
        return found == row.safety.end() ? nullptr : &*found;
      };
      std::string name = "safety_" + method;
      std::replace(name.begin(), name.end(), ' ', '_');
      return {{name,
               "",
               [of_row](const SweepRow &row) {
                 const SafetyFactor *const safety = of_row(row);
                 return safety != nullptr && safety->found()
                          ? safety->factor
                          : std::numeric_limits<double>::quiet_NaN();
               }},
              {name + "_verdict", "", [of_row](const SweepRow &row) {
                 const SafetyFactor *const safety = of_row(row);
                 return safety == nullptr ? SafetyFactor::not_computed : safety->verdict;
               }}};
    }
  } // namespace

  // The settings, joints and monitors of all variants are the same in number and order.
  template <int dim>
  Columns<SweepRow>
  sweep_columns(const Model<dim> &model, const Parameters &parameters)
  {
    const Units &u            = parameters.output.units;
    Columns<SweepRow> columns = {{"variant", "", [](const SweepRow &row) { return row.number; }}};
    for (std::size_t i = 0; i < parameters.swept.size(); ++i)
      append(columns,
             {{parameters.swept[i].name, parameters.swept[i].unit, [i](const SweepRow &row) {
                 return row.settings[i];
               }}});
    append(
      columns,
      {{"verdict", "", [](const SweepRow &row) { return row.verdict; }},
       {"mechanism", "", [](const SweepRow &row) { return mechanism_name(row.path.mechanism); }},
       {"t", "", [](const SweepRow &row) { return row.path.t; }},
       {"first_opening_t", "", [](const SweepRow &row) { return row.first_opening; }},
       {"first_slip_t", "", [](const SweepRow &row) { return row.first_slip; }},
       {"events", "", [](const SweepRow &row) { return row.path.n_events; }}});
    for (std::size_t j = 0; j < model.joint_names.size(); ++j)
      append(columns, columns_of_joint<dim>(j, model));
    if (has_dynamic_stage(model.parameters.model))
      append(columns,
             columns_of<SweepRow>(
               motion_energies(u),
               "work kinetic_energy energy_bodies damping joint_work numerical sudden "
               "largest_energy",
               [](const SweepRow &row) -> const auto & { return row.motion_energies; }));
    for (std::size_t i = 0; i < model.monitors.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        append(columns,
               {{model.monitors[i].name() + " u" + "xyz"[c], u.length, [i, c](const SweepRow &row) {
                   return row.displacements[i][c];
                 }}});
    append(columns,
           {{"certificate", "", [](const SweepRow &row) { return row.certificate; }},
            {"seconds", "", [](const SweepRow &row) { return row.seconds; }},
            {"driven_by", "", [](const SweepRow &row) { return row.drive.name; }},
            {"drive", "", [](const SweepRow &row) { return row.drive.value; }},
            {"motion", "", [](const SweepRow &row) { return row.motion; }},
            {"exit_code", "", [](const SweepRow &row) {
               return static_cast<std::size_t>(row.exit_code);
             }}});
    for (const std::string &method : methods(parameters))
      append(columns, columns_of_safety(method));
    return columns;
  }

  template Columns<SweepRow>
  sweep_columns(const Model<2> &, const Parameters &);
  template Columns<SweepRow>
  sweep_columns(const Model<3> &, const Parameters &);
} // namespace fuga
