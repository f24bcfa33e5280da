// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/tables/history_columns.h>

#include <limits>

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

    /** What drives the stage, beside its share that is done. */
    template <typename Row>
    Columns<Row>
    drive()
    {
      return {{"driven_by", "", [](const Row &row) { return row.moment.drive.name; }},
              {"drive", "", [](const Row &row) { return row.moment.drive.value; }}};
    }

    /** The three coordinates of the element of a row. */
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

    template <double JointResultant::*member>
    TableField
    of_resultant(const ResultantRow &row)
    {
      return row.resultant.*member;
    }

    template <double EnergyLedger::*member>
    TableField
    of_energies(const ResultantRow &row)
    {
      return row.energies.*member;
    }

    template <double JointResultant::*member>
    TableField
    of_joint(const MotionRow &row)
    {
      return row.resultant.*member;
    }

    template <double MotionLedger::*member>
    TableField
    of_motion(const MotionRow &row)
    {
      return row.moment.energies.*member;
    }

    template <std::size_t component>
    TableField
    of_ground(const MotionRow &row)
    {
      return row.moment.ground[component];
    }

    /** A component of a vector of a joint in space. */
    template <std::array<double, 3> JointResultant::*member, std::size_t component>
    TableField
    component_of(const ResultantRow &row)
    {
      return (row.resultant.*member)[component];
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

    Columns<ResultantRow>
    resultant_columns_in_space(const Units &u)
    {
      return {{"T2", u.force, of_resultant<&JointResultant::T2>},
              {"M1", u.energy(), of_resultant<&JointResultant::M1>},
              {"Mn", u.energy(), of_resultant<&JointResultant::Mn>},
              {"eccentricity2", u.length, of_resultant<&JointResultant::eccentricity2>},
              {"position_z", u.length, component_of<&JointResultant::position, 2>},
              {"normal_x", "", component_of<&JointResultant::normal, 0>},
              {"normal_y", "", component_of<&JointResultant::normal, 1>},
              {"normal_z", "", component_of<&JointResultant::normal, 2>},
              {"t1_x", "", component_of<&JointResultant::first_tangent, 0>},
              {"t1_y", "", component_of<&JointResultant::first_tangent, 1>},
              {"t1_z", "", component_of<&JointResultant::first_tangent, 2>}};
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
      load_time<ResultantRow>(),
      {"joint", "", [](const ResultantRow &row) { return row.joint; }},
      {"N", u.force, of_resultant<&JointResultant::N>},
      {"T", u.force, of_resultant<&JointResultant::T>},
      {"M", u.energy(), of_resultant<&JointResultant::M>},
      {"position_x", u.length, component_of<&JointResultant::position, 0>},
      {"position_y", u.length, component_of<&JointResultant::position, 1>},
      {"share_open", "", of_resultant<&JointResultant::share_open>},
      {"share_stick", "", of_resultant<&JointResultant::share_stick>},
      {"share_slip", "", of_resultant<&JointResultant::share_slip>},
      {"largest_pressure", u.stress(), of_resultant<&JointResultant::largest_pressure>},
      {"largest_gap", u.length, of_resultant<&JointResultant::largest_gap>},
      {"largest_slip", u.length, of_resultant<&JointResultant::largest_slip>},
      {"sliding_safety", "", of_resultant<&JointResultant::sliding_safety>},
      {"external_work", u.energy(), of_energies<&EnergyLedger::external_work>},
      {"energy_bodies", u.energy(), of_energies<&EnergyLedger::bodies>},
      {"energy_layer", u.energy(), of_energies<&EnergyLedger::layer>},
      {"dissipation", u.energy(), of_energies<&EnergyLedger::dissipation>},
      certificate<ResultantRow>(),
      path_length<ResultantRow>(u),
      {"eccentricity", u.length, of_resultant<&JointResultant::eccentricity>},
      {"in_middle_third",
       "",
       [in_space](const ResultantRow &row) {
         return in_space ? std::numeric_limits<double>::quiet_NaN()
                         : (row.resultant.in_middle_third ? 1. : 0.);
       }},
      {"overturning_safety", "", of_resultant<&JointResultant::overturning_safety>},
      {"share_compression", "", of_resultant<&JointResultant::share_compression>},
      {"cracked_length", u.length, of_resultant<&JointResultant::cracked_length>},
      {"crack_from_first", u.length, of_resultant<&JointResultant::crack_from_first>},
      {"crack_from_last", u.length, of_resultant<&JointResultant::crack_from_last>},
      {"smallest_pressure", u.stress(), of_resultant<&JointResultant::smallest_pressure>},
      {"joint_dissipation", u.energy(), of_resultant<&JointResultant::dissipation>}};
    if (in_space)
      append(columns, resultant_columns_in_space(u));
    if (has_water)
      append(columns, {{"water", u.force, of_resultant<&JointResultant::water>}});
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
      {"joint", "", [](const MotionRow &row) { return row.joint; }},
      {"N", u.force, of_joint<&JointResultant::N>},
      {"T", u.force, of_joint<&JointResultant::T>},
      {"mean_slip", u.length, of_joint<&JointResultant::mean_slip>},
      {"largest_slip", u.length, of_joint<&JointResultant::largest_slip>},
      {"largest_gap", u.length, of_joint<&JointResultant::largest_gap>},
      {"share_open", "", of_joint<&JointResultant::share_open>},
      {"share_stick", "", of_joint<&JointResultant::share_stick>},
      {"share_slip", "", of_joint<&JointResultant::share_slip>},
      {"ground_x", u.acceleration(), of_ground<0>},
      {"ground_y", u.acceleration(), of_ground<1>},
      {"work", u.energy(), of_motion<&MotionLedger::work>},
      {"kinetic_energy", u.energy(), of_motion<&MotionLedger::kinetic>},
      {"energy_bodies", u.energy(), of_motion<&MotionLedger::bodies>},
      {"damping", u.energy(), of_motion<&MotionLedger::damping>},
      {"joint_work", u.energy(), of_motion<&MotionLedger::joints>},
      {"numerical", u.energy(), of_motion<&MotionLedger::numerical>},
      {"sudden", u.energy(), of_motion<&MotionLedger::sudden>}};
    if (in_space)
      append(columns,
             {{"T2", u.force, of_joint<&JointResultant::T2>},
              {"mean_slip2", u.length, of_joint<&JointResultant::mean_slip2>},
              {"ground_z", u.acceleration(), of_ground<2>}});
    return columns;
  }
} // namespace fuga
