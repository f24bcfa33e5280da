// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/tables/history_writer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  }

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

  HistoryWriter::HistoryWriter(const std::string &directory, const HistoryContext &history_context)
    : context(history_context)
    , events(directory + "/events.csv", event_columns(context.units, context.has_motion))
    , history(directory + "/joint_history.csv", history_columns(context.units, context.has_water))
    , resultants(directory + "/resultants.csv",
                 resultant_columns(context.units, context.has_water, context.in_space))
  {
    if (!context.monitors.empty())
      monitors = std::make_unique<Table<MonitorRow>>(
        directory + "/monitors.csv", monitor_columns(context.units, context.in_space));
    if (context.has_motion)
      motion = std::make_unique<Table<MotionRow>>(directory + "/earthquake.csv",
                                                  motion_columns(context.units, context.in_space));
    if (context.spectra.wanted)
      {
        accelerations = std::make_unique<Table<AccelerationRow>>(
          directory + "/accelerations.csv", acceleration_columns(context.units, context.in_space));
        spectra = std::make_unique<Table<SpectrumRow>>(directory + "/spectra.csv",
                                                       spectrum_columns(context.units));
      }
  }

  Moment
  HistoryWriter::moment(const double t, const std::size_t stage, const double certificate) const
  {
    return {t, context.driving.at(t, stage), certificate, length_beyond};
  }

  void
  HistoryWriter::add_events(const std::vector<ContactEvent> &new_events, const double certificate)
  {
    for (const ContactEvent &event : new_events)
      add_event(event.t, certificate, event.element, event.names(), event.n_branches, unknown);
  }

  void
  HistoryWriter::add_event(const MotionEvent &event)
  {
    add_event(event.t, unknown, event.element, event.names, 1, event.energy);
  }

  void
  HistoryWriter::add_event(const double t,
                           const double certificate,
                           const std::size_t number,
                           const std::array<std::string_view, 2> &names,
                           const std::size_t n_branches,
                           const double energy)
  {
    const ContactElement &element = context.elements[number];
    const auto [stage, fraction]  = stage_of_event(t, context.stage_names.size());
    events.add({moment(t, stage, certificate),
                ++n_events,
                names,
                n_branches,
                energy,
                element,
                context.joint_names[element.joint],
                context.stage_names[stage],
                fraction});
  }

  void
  HistoryWriter::add_level(const double t,
                           const std::vector<ElementResult> &results,
                           const std::vector<JointResultant> &joint_resultants,
                           const EnergyLedger &energies,
                           const double certificate)
  {
    const Moment now = moment(t, stage_of(t, context.stage_names.size()).first, certificate);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        history.add({now, context.joint_names[element.joint], element, results[k]});
      }
    for (unsigned int joint = 0; joint < context.joint_names.size(); ++joint)
      if (context.joints_there[joint])
        resultants.add({now, context.joint_names[joint], joint_resultants[joint], energies});
  }

  template <typename Writer, typename Visitor>
  void
  HistoryWriter::for_each_table(Writer &writer, const Visitor &visit)
  {
    visit(writer.events);
    visit(writer.history);
    visit(writer.resultants);
    const auto visit_if_there = [&visit](const auto &table) {
      if (table)
        visit(*table);
    };
    visit_if_there(writer.monitors);
    visit_if_there(writer.motion);
    visit_if_there(writer.accelerations);
    visit_if_there(writer.spectra);
  }

  HistoryMemory
  HistoryWriter::memory() const
  {
    HistoryMemory result;
    for_each_table(*this, [&result](const TextFile &table) {
      result.files.emplace_back(table.name(), table.memory());
    });
    result.n_events = n_events;
    return result;
  }

  void
  HistoryWriter::restore(const HistoryMemory &memory)
  {
    std::size_t n_restored = 0;
    for_each_table(*this,
                   [&](TextFile &table) { table.restore(memory.files.at(n_restored++).second); });
    n_events = memory.n_events;
  }

  void
  HistoryWriter::add_monitors(const double t,
                              const std::string &occasion,
                              const Vector &coordinates,
                              const Vector &factors,
                              const Vector &thermal_strains)
  {
    const std::size_t n_stages = context.stage_names.size();
    const std::size_t stage =
      (occasion == "event" ? stage_of_event(t, n_stages) : stage_of(t, n_stages)).first;
    const Moment now = moment(t, stage, unknown);
    for (std::size_t i = 0; i < context.monitors.size(); ++i)
      {
        const Monitor &monitor = context.monitors[i];
        monitors->add({now,
                       occasion,
                       monitor,
                       monitor.displacement(coordinates, factors),
                       monitor.stress(coordinates, factors, thermal_strains[i])});
      }
  }

  void
  HistoryWriter::add_motion(const double t,
                            const MotionMoment &moment,
                            const std::vector<JointResultant> &joint_resultants)
  {
    for (unsigned int joint = 0; joint < context.joint_names.size(); ++joint)
      if (context.joints_there[joint])
        motion->add({t, moment, context.joint_names[joint], joint_resultants[joint]});
  }

  // An oscillator of period 0 follows the motion.
  void
  HistoryWriter::add_accelerations(const std::size_t stage,
                                   const std::vector<std::array<GroundMotion, 3>> &of_monitors)
  {
    for (std::size_t i = 0; i < of_monitors.size(); ++i)
      {
        const std::array<GroundMotion, 3> &along = of_monitors[i];
        const std::string &name                  = context.monitors[i].name();
        for (std::size_t n = 0; n < along[0].accelerations.size(); ++n)
          accelerations->add(
            {context.stage_names[stage],
             name,
             static_cast<double>(n) * along[0].step,
             {{along[0].accelerations[n], along[1].accelerations[n], along[2].accelerations[n]}}});
        for (std::size_t c = 0; c < (context.in_space ? 3 : 2); ++c)
          {
            std::vector<SpectralResponse> spectrum =
              response_spectrum(along[c], context.spectra.periods, context.spectra.damping);
            spectrum.insert(spectrum.begin(), {0., 0., 0., max_abs(along[c].accelerations)});
            for (const SpectralResponse &response : spectrum)
              spectra->add(
                {context.stage_names[stage], name, static_cast<char>('x' + c), response});
          }
      }
  }

  void
  HistoryWriter::publish(const bool now)
  {
    for_each_table(*this, [now](TextFile &table) { table.publish(now); });
  }
} // namespace fuga
