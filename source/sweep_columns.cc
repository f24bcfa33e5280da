// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/summary.h>
#include <fuga/sweep_row.h>

namespace fuga
{
  namespace
  {
    template <int dim>
    Columns<SweepRow>
    columns_of_joint(const std::size_t j, const Model<dim> &model)
    {
      const Units &u          = model.parameters.output.units;
      const std::string joint = model.joint_names[j] + " ";
      const auto of_joint     = [j](double JointResultant::*const member) {
        return [j, member](const SweepRow &row) { return row.resultants[j].*member; };
      };
      Columns<SweepRow> columns = {{joint + "N", u.force, of_joint(&JointResultant::N)},
                                   {joint + "T", u.force, of_joint(&JointResultant::T)}};
      if (dim == 3)
        append(columns, {{joint + "T2", u.force, of_joint(&JointResultant::T2)}});
      append(columns,
             {{joint + "M", u.energy(), of_joint(&JointResultant::M)},
              {joint + "share_open", "", of_joint(&JointResultant::share_open)},
              {joint + "share_slip", "", of_joint(&JointResultant::share_slip)},
              {joint + "largest_pressure", u.stress(), of_joint(&JointResultant::largest_pressure)},
              {joint + "sliding_safety", "", of_joint(&JointResultant::sliding_safety)},
              {joint + "overturning_safety", "", of_joint(&JointResultant::overturning_safety)},
              {joint + "cracked_length", u.length, of_joint(&JointResultant::cracked_length)}});
      return columns;
    }
  } // namespace

  // The settings, joints and monitors of all variants are the same in number and order.
  template <int dim>
  Columns<SweepRow>
  sweep_columns(const Model<dim> &model)
  {
    const Units &u            = model.parameters.output.units;
    Columns<SweepRow> columns = {{"variant", "", [](const SweepRow &row) { return row.number; }}};
    const auto &settings      = model.parameters.variants.front().settings;
    for (std::size_t i = 0; i < settings.size(); ++i)
      append(columns,
             {{settings[i].first, "", [i](const SweepRow &row) { return row.settings[i]; }}});
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
            {"motion", "", [](const SweepRow &row) { return row.motion; }}});
    return columns;
  }

  template Columns<SweepRow>
  sweep_columns(const Model<2> &);
  template Columns<SweepRow>
  sweep_columns(const Model<3> &);
} // namespace fuga
