// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/tables/history_columns.h>

namespace fuga
{
  namespace
  {
    template <typename Row>
    Column<Row>
    load_time()
    {
      return {"t", "", [](const Row &row) { return row.moment.t; }};
    }

    template <typename Row>
    Column<Row>
    path_length(const Units &u)
    {
      return {"path_length", u.length, [](const Row &row) { return row.moment.path_length; }};
    }

    template <typename Row>
    Column<Row>
    certificate()
    {
      return {"certificate", "", [](const Row &row) { return row.moment.certificate; }};
    }

    /** Return the columns of what drives the stage, besides the share of the stage that is done. */
    template <typename Row>
    Columns<Row>
    drive()
    {
      return {{"driven_by", "", [](const Row &row) { return row.moment.drive.name; }},
              {"drive", "", [](const Row &row) { return row.moment.drive.value; }}};
    }

    /** Return the three coordinates of the element of a row. */
    template <typename Row>
    Columns<Row>
    place_of_element(const Units &u)
    {
      return {{"x", u.length, [](const Row &row) { return row.element.position[0]; }},
              {"y", u.length, [](const Row &row) { return row.element.position[1]; }},
              {"z", u.length, [](const Row &row) { return row.element.position[2]; }}};
    }

    template <double ElementResult::*member>
    TableField
    of_result(const ElementRow &row)
    {
      return row.result.*member;
    }

    /** Append the columns @p names of the joint of a row. */
    template <typename Row>
    void
    append_of_joint(const Units &u, const std::string &names, Columns<Row> &columns)
    {
      append(columns,
             columns_of<Row>(
               resultant_quantities(u), names, [](const Row &row) -> const auto & {
                 return row.resultant;
               }));
    }

    template <double EnergyLedger::*member>
    TableField
    of_energies(const ResultantRow &row)
    {
      return row.energies.*member;
    }

    template <std::size_t component>
    TableField
    of_ground(const MotionRow &row)
    {
      return row.moment.ground[component];
    }

    template <std::size_t component>
    TableField
    displacement(const MonitorRow &row)
    {
      return row.displacement[component];
    }

    template <std::size_t component>
    TableField
    acceleration(const AccelerationRow &row)
    {
      return row.acceleration[component];
    }

    template <double SpectralResponse::*member>
    TableField
    of_response(const SpectrumRow &row)
    {
      return row.response.*member;
    }

    template <std::size_t component>
    TableField
    stress(const MonitorRow &row)
    {
      return row.stress[component];
    }

    template <std::size_t component>
    TableField
    place_of_monitor(const MonitorRow &row)
    {
      return row.monitor.position()[component];
    }
  } // namespace

  Columns<EventRow>
  event_columns(const Units &u, const bool has_motion)
  {
    Columns<EventRow> columns = {
      {"event", "", [](const EventRow &row) { return row.number; }},
      load_time<EventRow>(),
      {"stage", "", [](const EventRow &row) { return row.stage; }},
      {"stage_fraction", "", [](const EventRow &row) { return row.stage_fraction; }},
      {"joint", "", [](const EventRow &row) { return row.joint; }},
      {"element", "", [](const EventRow &row) { return std::size_t{row.element.number}; }}};
    append(columns, place_of_element<EventRow>(u));
    append(columns,
           {{"from", "", [](const EventRow &row) { return std::string(row.names[0]); }},
            {"to", "", [](const EventRow &row) { return std::string(row.names[1]); }},
            certificate<EventRow>(),
            {"continuations", "", [](const EventRow &row) { return row.n_branches; }},
            path_length<EventRow>(u)});
    if (has_motion)
      append(columns, {{"energy", u.energy(), [](const EventRow &row) { return row.energy; }}});
    append(columns, drive<EventRow>());
    return columns;
  }

  Columns<ElementRow>
  history_columns(const Units &u, const bool has_water)
  {
    Columns<ElementRow> columns = {
      load_time<ElementRow>(),
      {"joint", "", [](const ElementRow &row) { return row.joint; }},
      {"element", "", [](const ElementRow &row) { return std::size_t{row.element.number}; }}};
    append(columns, place_of_element<ElementRow>(u));
    append(columns,
           {{"area", u.length + "2", [](const ElementRow &row) { return row.element.area; }},
            {"state",
             "",
             [](const ElementRow &row) { return std::string(state_name(row.result.state)); }},
            {"N", u.force, of_result<&ElementResult::N>},
            {"T1", u.force, of_result<&ElementResult::T>},
            {"T2", u.force, of_result<&ElementResult::T2>},
            {"pressure", u.stress(), of_result<&ElementResult::pressure>},
            {"shear1", u.stress(), of_result<&ElementResult::shear>},
            {"shear2", u.stress(), of_result<&ElementResult::shear2>},
            {"gap", u.length, of_result<&ElementResult::gap>},
            {"slip1", u.length, of_result<&ElementResult::slip>},
            {"slip2", u.length, of_result<&ElementResult::slip2>},
            {"jump_n", u.length, of_result<&ElementResult::jump_n>},
            {"jump_t1", u.length, of_result<&ElementResult::jump_t>},
            {"jump_t2", u.length, of_result<&ElementResult::jump_t2>},
            path_length<ElementRow>(u)});
    if (has_water)
      append(columns, {{"water_pressure", u.stress(), of_result<&ElementResult::water_pressure>}});
    append(columns, drive<ElementRow>());
    return columns;
  }

  Columns<ResultantRow>
  resultant_columns(const Units &u, const bool has_water, const bool in_space)
  {
    Columns<ResultantRow> columns = {
      load_time<ResultantRow>(), {"joint", "", [](const ResultantRow &row) { return row.joint; }}};
    append_of_joint(
      u,
      "N T M position_x position_y share_open share_stick share_slip largest_pressure "
      "largest_gap largest_slip sliding_safety",
      columns);
    append(columns,
           {{"external_work", u.energy(), of_energies<&EnergyLedger::external_work>},
            {"energy_bodies", u.energy(), of_energies<&EnergyLedger::bodies>},
            {"energy_layer", u.energy(), of_energies<&EnergyLedger::layer>},
            {"dissipation", u.energy(), of_energies<&EnergyLedger::dissipation>},
            certificate<ResultantRow>(),
            path_length<ResultantRow>(u)});
    append_of_joint(
      u,
      "eccentricity in_middle_third overturning_safety share_compression cracked_length "
      "crack_from_first crack_from_last smallest_pressure joint_dissipation",
      columns);
    if (in_space)
      append_of_joint(u,
                      "T2 M1 Mn eccentricity2 position_z normal_x normal_y "
                      "normal_z t1_x t1_y t1_z",
                      columns);
    if (has_water)
      append_of_joint(u, "water", columns);
    append(columns, drive<ResultantRow>());
    return columns;
  }

  Columns<MonitorRow>
  monitor_columns(const Units &u, const bool in_space)
  {
    Columns<MonitorRow> columns = {
      load_time<MonitorRow>(),
      {"occasion", "", [](const MonitorRow &row) { return row.occasion; }},
      {"monitor", "", [](const MonitorRow &row) { return row.monitor.name(); }},
      {"x", u.length, place_of_monitor<0>},
      {"y", u.length, place_of_monitor<1>},
      {"z", u.length, place_of_monitor<2>},
      {"ux", u.length, displacement<0>},
      {"uy", u.length, displacement<1>},
      {"uz", u.length, displacement<2>},
      path_length<MonitorRow>(u),
      {"stress_xx", u.stress(), stress<0>},
      {"stress_yy", u.stress(), stress<1>},
      {"stress_zz", u.stress(), stress<2>},
      {"stress_xy", u.stress(), stress<3>}};
    if (in_space)
      append(columns, {{"stress_xz", u.stress(), stress<4>}, {"stress_yz", u.stress(), stress<5>}});
    append(columns, drive<MonitorRow>());
    return columns;
  }

  Columns<AccelerationRow>
  acceleration_columns(const Units &u, const bool in_space)
  {
    Columns<AccelerationRow> columns = {
      {"stage", "", [](const AccelerationRow &row) { return row.stage; }},
      {"monitor", "", [](const AccelerationRow &row) { return row.monitor; }},
      {"time", "s", [](const AccelerationRow &row) { return row.time; }},
      {"ax", u.acceleration(), acceleration<0>},
      {"ay", u.acceleration(), acceleration<1>}};
    if (in_space)
      append(columns, {{"az", u.acceleration(), acceleration<2>}});
    return columns;
  }

  Columns<SpectrumRow>
  spectrum_columns(const Units &u)
  {
    return {{"stage", "", [](const SpectrumRow &row) { return row.stage; }},
            {"monitor", "", [](const SpectrumRow &row) { return row.monitor; }},
            {"axis", "", [](const SpectrumRow &row) { return std::string(1, row.axis); }},
            {"period", "s", of_response<&SpectralResponse::period>},
            {"pseudo_acceleration",
             u.acceleration(),
             of_response<&SpectralResponse::pseudo_acceleration>},
            {"velocity", u.length + "/s", of_response<&SpectralResponse::velocity>},
            {"displacement", u.length, of_response<&SpectralResponse::displacement>}};
  }

  Columns<MotionRow>
  motion_columns(const Units &u, const bool in_space)
  {
    Columns<MotionRow> columns = {
      {"t", "", [](const MotionRow &row) { return row.t; }},
      {"time", "s", [](const MotionRow &row) { return row.moment.time; }},
      {"joint", "", [](const MotionRow &row) { return row.joint; }}};
    append_of_joint(u,
                    "N T mean_slip largest_slip largest_gap share_open share_stick "
                    "share_slip",
                    columns);
    append(
      columns,
      {{"ground_x", u.acceleration(), of_ground<0>}, {"ground_y", u.acceleration(), of_ground<1>}});
    append(columns,
           columns_of<MotionRow>(
             motion_energies(u),
             "work kinetic_energy energy_bodies damping joint_work numerical sudden",
             [](const MotionRow &row) -> const auto & { return row.moment.energies; }));
    if (in_space)
      {
        append_of_joint(u, "T2 mean_slip2", columns);
        append(columns, {{"ground_z", u.acceleration(), of_ground<2>}});
      }
    return columns;
  }
} // namespace fuga
