// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/history_writer.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  std::pair<std::size_t, double>
  stage_of(const double t, const std::size_t n_stages)
  {
    const double number = std::clamp(std::ceil(t) - 1., 0., static_cast<double>(n_stages - 1));
    return {static_cast<std::size_t>(number), t - number};
  }

  std::pair<std::size_t, double>
  stage_of_event(const double t, const std::size_t n_stages)
  {
    const double number = std::clamp(std::floor(t), 0., static_cast<double>(n_stages - 1));
    return {static_cast<std::size_t>(number), t - number};
  }

  namespace
  {
    std::vector<std::string>
    event_columns(const Units &u)
    {
      return {"event",
              "t",
              "stage",
              "stage_fraction",
              "joint",
              "element",
              fmt::format("x[{}]", u.length),
              fmt::format("y[{}]", u.length),
              fmt::format("z[{}]", u.length),
              "from",
              "to",
              "certificate",
              "continuations",
              fmt::format("path_length[{}]", u.length)};
    }

    std::vector<std::string>
    history_columns(const Units &u, const bool has_water)
    {
      std::vector<std::string> columns = {"t", "joint", "element"};
      for (const char *name : {"x", "y", "z"})
        columns.push_back(fmt::format("{}[{}]", name, u.length));
      columns.push_back(fmt::format("area[{}2]", u.length));
      columns.push_back("state");
      for (const char *name : {"N", "T1", "T2"})
        columns.push_back(fmt::format("{}[{}]", name, u.force));
      for (const char *name : {"pressure", "shear1", "shear2"})
        columns.push_back(fmt::format("{}[{}]", name, u.stress()));
      for (const char *name : {"gap", "slip1", "slip2", "jump_n", "jump_t1", "jump_t2"})
        columns.push_back(fmt::format("{}[{}]", name, u.length));
      columns.push_back(fmt::format("path_length[{}]", u.length));
      if (has_water)
        columns.push_back(fmt::format("water_pressure[{}]", u.stress()));
      return columns;
    }

    std::vector<std::string>
    resultant_columns(const Units &u, const bool has_water, const bool in_space)
    {
      std::vector<std::string> columns = {"t",
                                          "joint",
                                          fmt::format("N[{}]", u.force),
                                          fmt::format("T[{}]", u.force),
                                          fmt::format("M[{}]", u.energy()),
                                          fmt::format("position_x[{}]", u.length),
                                          fmt::format("position_y[{}]", u.length),
                                          "share_open",
                                          "share_stick",
                                          "share_slip",
                                          fmt::format("largest_pressure[{}]", u.stress()),
                                          fmt::format("largest_gap[{}]", u.length),
                                          fmt::format("largest_slip[{}]", u.length),
                                          "sliding_safety",
                                          fmt::format("external_work[{}]", u.energy()),
                                          fmt::format("energy_bodies[{}]", u.energy()),
                                          fmt::format("energy_layer[{}]", u.energy()),
                                          fmt::format("dissipation[{}]", u.energy()),
                                          "certificate",
                                          fmt::format("path_length[{}]", u.length),
                                          fmt::format("eccentricity[{}]", u.length),
                                          "in_middle_third",
                                          "overturning_safety",
                                          "share_compression",
                                          fmt::format("cracked_length[{}]", u.length),
                                          fmt::format("crack_from_first[{}]", u.length),
                                          fmt::format("crack_from_last[{}]", u.length),
                                          fmt::format("smallest_pressure[{}]", u.stress()),
                                          fmt::format("joint_dissipation[{}]", u.energy())};
      if (in_space)
        for (const std::string &column : {fmt::format("T2[{}]", u.force),
                                          fmt::format("M1[{}]", u.energy()),
                                          fmt::format("Mn[{}]", u.energy()),
                                          fmt::format("eccentricity2[{}]", u.length),
                                          fmt::format("position_z[{}]", u.length),
                                          std::string("normal_x"),
                                          std::string("normal_y"),
                                          std::string("normal_z"),
                                          std::string("t1_x"),
                                          std::string("t1_y"),
                                          std::string("t1_z")})
          columns.push_back(column);
      if (has_water)
        columns.push_back(fmt::format("water[{}]", u.force));
      return columns;
    }

    std::vector<std::string>
    monitor_columns(const Units &u, const bool in_space)
    {
      std::vector<std::string> columns = {"t", "occasion", "monitor"};
      for (const char *name : {"x", "y", "z", "ux", "uy", "uz"})
        columns.push_back(fmt::format("{}[{}]", name, u.length));
      columns.push_back(fmt::format("path_length[{}]", u.length));
      for (const char *name : {"stress_xx", "stress_yy", "stress_zz", "stress_xy"})
        columns.push_back(fmt::format("{}[{}]", name, u.stress()));
      for (const char *name : {"stress_xz", "stress_yz"})
        if (in_space)
          columns.push_back(fmt::format("{}[{}]", name, u.stress()));
      return columns;
    }
  } // namespace

  HistoryWriter::HistoryWriter(const std::string &directory, const HistoryContext &history_context)
    : context(history_context)
    , events(directory + "/events.csv", event_columns(context.units))
    , history(directory + "/joint_history.csv", history_columns(context.units, context.has_water))
    , resultants(directory + "/resultants.csv",
                 resultant_columns(context.units, context.has_water, context.in_space))
  {
    if (!context.monitors.empty())
      monitors = std::make_unique<CsvFile>(directory + "/monitors.csv",
                                           monitor_columns(context.units, context.in_space));
  }

  void
  HistoryWriter::add_events(const std::vector<ContactEvent> &new_events, const double certificate)
  {
    for (const ContactEvent &event : new_events)
      {
        const ContactElement &element = context.elements[event.element];
        const auto [stage, fraction]  = stage_of_event(event.t, context.stage_names.size());
        events.add(++n_events);
        events.add(event.t);
        events.add(context.stage_names[stage]);
        events.add(fraction);
        events.add(context.joint_names[element.joint]);
        events.add(std::size_t{element.number});
        for (const double x : element.position)
          events.add(x);
        events.add(std::string(state_name(event.from)));
        events.add(std::string(state_name(event.to)));
        events.add(certificate);
        events.add(event.n_branches);
        events.add(length_beyond);
        events.end_row();
      }
  }

  void
  HistoryWriter::add_level(const double t,
                           const std::vector<ElementResult> &results,
                           const std::vector<JointResultant> &joint_resultants,
                           const EnergyLedger &energies,
                           const double certificate)
  {
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        const ElementResult &r        = results[k];
        history.add(t);
        history.add(context.joint_names[element.joint]);
        history.add(std::size_t{element.number});
        for (const double x : element.position)
          history.add(x);
        history.add(element.area);
        history.add(std::string(state_name(r.state)));
        for (const double value : {r.N,
                                   r.T,
                                   r.T2,
                                   r.pressure,
                                   r.shear,
                                   r.shear2,
                                   r.gap,
                                   r.slip,
                                   r.slip2,
                                   r.jump_n,
                                   r.jump_t,
                                   r.jump_t2})
          history.add(value);
        history.add(length_beyond);
        if (context.has_water)
          history.add(r.water_pressure);
        history.end_row();
      }
    for (unsigned int joint = 0; joint < context.joint_names.size(); ++joint)
      {
        if (!context.joints_there[joint])
          continue;
        const JointResultant &r = joint_resultants[joint];
        resultants.add(t);
        resultants.add(context.joint_names[joint]);
        for (const double value : {r.N,
                                   r.T,
                                   r.M,
                                   r.position[0],
                                   r.position[1],
                                   r.share_open,
                                   r.share_stick,
                                   r.share_slip,
                                   r.largest_pressure,
                                   r.largest_gap,
                                   r.largest_slip,
                                   r.sliding_safety,
                                   energies.external_work,
                                   energies.bodies,
                                   energies.layer,
                                   energies.dissipation,
                                   certificate,
                                   length_beyond,
                                   r.eccentricity,
                                   context.in_space ? std::numeric_limits<double>::quiet_NaN()
                                                    : (r.in_middle_third ? 1. : 0.),
                                   r.overturning_safety,
                                   r.share_compression,
                                   r.cracked_length,
                                   r.crack_from_first,
                                   r.crack_from_last,
                                   r.smallest_pressure,
                                   r.dissipation})
          resultants.add(value);
        if (context.in_space)
          for (const double value : {r.T2,
                                     r.M1,
                                     r.Mn,
                                     r.eccentricity2,
                                     r.position[2],
                                     r.normal[0],
                                     r.normal[1],
                                     r.normal[2],
                                     r.first_tangent[0],
                                     r.first_tangent[1],
                                     r.first_tangent[2]})
            resultants.add(value);
        if (context.has_water)
          resultants.add(r.water);
        resultants.end_row();
      }
  }

  HistoryMemory
  HistoryWriter::memory() const
  {
    return {events.memory(),
            history.memory(),
            resultants.memory(),
            monitors ? monitors->memory() : TextMemory(),
            n_events};
  }

  void
  HistoryWriter::restore(const HistoryMemory &memory)
  {
    events.restore(memory.events);
    history.restore(memory.history);
    resultants.restore(memory.resultants);
    if (monitors)
      monitors->restore(memory.monitors);
    n_events = memory.n_events;
  }

  void
  HistoryWriter::add_monitors(const double t,
                              const std::string &occasion,
                              const Vector &coordinates,
                              const Vector &factors,
                              const Vector &thermal_strains)
  {
    for (std::size_t i = 0; i < context.monitors.size(); ++i)
      {
        const Monitor &monitor = context.monitors[i];
        monitors->add(t);
        monitors->add(occasion);
        monitors->add(monitor.name());
        for (const double x : monitor.position())
          monitors->add(x);
        for (const double u : monitor.displacement(coordinates, factors))
          monitors->add(u);
        monitors->add(length_beyond);
        const auto stress = monitor.stress(coordinates, factors, thermal_strains[i]);
        for (std::size_t k = 0; k < (context.in_space ? 6 : 4); ++k)
          monitors->add(stress[k]);
        monitors->end_row();
      }
  }

  void
  HistoryWriter::publish(const bool now)
  {
    events.publish(now);
    history.publish(now);
    resultants.publish(now);
    if (monitors)
      monitors->publish(now);
  }
} // namespace fuga
