// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/dynamics/ground_motion.h>
#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/input/dynamics/dynamics_readers.h>
#include <fuga/input/dynamics/record_reader.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Return the stage at whose beginning the ground begins to move. */
    unsigned int
    read_stage(const ParameterSection &section, const std::vector<StageDefinition> &stages)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      std::vector<std::string> all, dynamic;
      for (const StageDefinition &stage : stages)
        {
          all.push_back(stage.name);
          if (stage.is_dynamic())
            dynamic.push_back(stage.name);
        }
      if (!section.given(e.stage) && dynamic.size() > 1)
        section.fail(fmt::format("'{}' is missing: the stages {} have a Duration. Name the one in "
                                 "which the ground moves.",
                                 e.stage.name(),
                                 quoted_list(dynamic)));
      const std::string name    = section.given(e.stage) ? section.value(e.stage) : dynamic.front();
      const unsigned int number = number_of(name, all, "stage", section, e.stage);
      if (!stages[number].is_dynamic())
        section.fail(e.stage,
                     fmt::format("this stage has no Duration ({}). Add it, or name one of {}.",
                                 stages[number].origin,
                                 quoted_list(dynamic)));
      return number;
    }


    std::string
    read_text(const ParameterSection &section, const Text &entry, const std::string &path)
    {
      std::error_code ignored;
      std::ifstream file(path, std::ios::binary);
      if (!fs::is_regular_file(path, ignored) || !file)
        section.fail(entry,
                     fmt::format("the record '{}' does not exist, or cannot be read. The name is "
                                 "relative to the folder of the parameter file.",
                                 path));
      std::stringstream text;
      text << file.rdbuf();
      return text.str();
    }


    RecordFormat
    format_of(const ParameterSection &section, const std::string &path)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      std::string ending         = fs::path(path).extension().string();
      for (char &c : ending)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return section.value_or(e.format,
                              ending == ".at2" ? RecordFormat::at2 : RecordFormat::columns);
    }


    /** Read the entries that only one of the formats has. */
    RecordColumns
    read_columns(const ParameterSection &section, const RecordFormat format)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      if (format == RecordFormat::at2 && section.given(e.record_step))
        section.fail(e.record_step,
                     "a record of the format at2 has its step in the file. Remove this entry, or "
                     "correct 'Record format'.");
      const RecordColumns columns = {section.value(e.time_column),
                                     section.value_or(e.record_step, 0.),
                                     section.value(e.acceleration_column)};
      if (format == RecordFormat::at2)
        return columns;
      if (columns.time == 0 && columns.step == 0.)
        section.fail(e.time_column,
                     fmt::format("without a column of times '{}' is needed. {}",
                                 e.record_step.name(),
                                 e.record_step.declaration->documentation));
      if (columns.time > 0 && columns.step > 0.)
        section.fail(e.record_step,
                     "the record has a column of times. Remove this entry, or write 'Time column = "
                     "0'.");
      if (columns.time == columns.acceleration)
        section.fail(
          e.acceleration_column,
          fmt::format("this is also '{}'. Correct one of the two.", e.time_column.name()));
      return columns;
    }


    GroundMotion
    read_record(const ParameterSection &section, const Text &entry, const std::string &folder)
    {
      const std::string path      = (fs::path(folder) / section.value(entry)).lexically_normal();
      const std::string text      = read_text(section, entry, path);
      const RecordFormat format   = format_of(section, path);
      const RecordColumns columns = read_columns(section, format);
      return format == RecordFormat::at2 ? read_record_at2(path, text)
                                         : read_record_in_columns(path, text, columns);
    }


    void
    read_ground(const ParameterSection &section,
                const Parameters &parameters,
                DynamicsDefinition &dynamics)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      const double factor =
        section.value(e.scale) * (section.value(e.unit) == RecordUnit::g ? dynamics.gravity : 1.);
      if (factor == 0.)
        section.fail(e.scale, "the ground would not move. Write a factor that is not 0.");
      double shortest_step = 0.;
      for (std::size_t axis = 0; axis < e.records.size(); ++axis)
        {
          const Text &entry = e.records[axis];
          if (!section.given(entry))
            continue;
          if (axis == 2 && parameters.model.dimension == 2)
            section.fail(entry, "a plane problem has no z; y is upwards. Remove this entry.");
          if (axis == 0 && parameters.model.assumption == PlaneAssumption::axisymmetric)
            section.fail(entry,
                         "the axis of a body of revolution does not move sideways. Remove this "
                         "entry; 'Record y' moves it along the axis.");
          GroundMotion &motion = dynamics.ground[axis];
          motion = read_record(section, entry, fs::path(parameters.parameter_file).parent_path());
          for (double &acceleration : motion.accelerations)
            acceleration *= factor;
          if (dynamics.baseline == Baseline::parabolic)
            motion = without_parabola(motion);
          shortest_step = shortest_step == 0. ? motion.step : std::min(shortest_step, motion.step);
        }
      if (shortest_step == 0.)
        section.fail(fmt::format("no record is given, so that the ground does not move. Add '{}', "
                                 "or remove the section.",
                                 e.records.front().name()));
      if (dynamics.time_step == 0.)
        dynamics.time_step = shortest_step;
    }


    /** Return the boundaries through which waves also leave, whether or not they are named among
     * those. */
    NamedBoundaries
    read_also_absorbing(const ParameterSection &section,
                        const Text &entry,
                        NamedBoundaries &absorbing)
    {
      if (!section.given(entry))
        return {};
      const NamedBoundaries result = {section.list(entry), section.origin(entry)};
      for (const std::string &name : result.names)
        if (std::find(absorbing.names.begin(), absorbing.names.end(), name) ==
            absorbing.names.end())
          absorbing.names.push_back(name);
      if (absorbing.origin.empty())
        absorbing.origin = result.origin;
      return result;
    }


    void
    read_base(const ParameterSection &section, DynamicsDefinition &dynamics)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      dynamics.compliant_base = read_also_absorbing(section, e.compliant_base, dynamics.absorbing);
      if (section.given(e.compliant_base) != section.given(e.motion))
        section.fail(section.given(e.motion) ? AnyEntry(e.motion) : AnyEntry(e.compliant_base),
                     section.given(e.motion)
                       ? fmt::format("without '{}' the record is the motion of the ground itself. "
                                     "Remove this entry, or add that one.",
                                     e.compliant_base.name())
                       : fmt::format("'{}' is missing. {}",
                                     e.motion.name(),
                                     e.motion.declaration->documentation));
      if (section.given(e.motion) && section.value(e.motion) == RecordMotion::outcrop)
        dynamics.upward_share = 0.5;
    }


    void
    read_free_field(const ParameterSection &section,
                    const ModelDefinition &model,
                    DynamicsDefinition &dynamics)
    {
      const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
      if (!section.given(e.free_field))
        return;
      if (model.dimension == 2 && model.assumption == PlaneAssumption::axisymmetric)
        section.fail(
          e.free_field,
          "the ground beside a model is computed in space and for plane problems without an axis. "
          "Move the side away and name it in 'Dynamics/Absorbing boundaries'.");
      dynamics.free_field = read_also_absorbing(section, e.free_field, dynamics.absorbing);
    }


    void
    read_added_mass(const ParameterSection &section, DynamicsDefinition &dynamics)
    {
      const EarthquakeEntries &e               = entries_of<EarthquakeEntries>();
      const std::array<AnyEntry, 3> quantities = {{e.level, e.bottom, e.unit_weight}};
      for (const AnyEntry &entry : quantities)
        if (section.given(entry) != section.given(e.added_mass))
          section.fail(section.given(entry) ? entry : AnyEntry(e.added_mass),
                       fmt::format("'{}' is missing, without which this does nothing. {}",
                                   (section.given(entry) ? AnyEntry(e.added_mass) : entry).name(),
                                   "Give all four entries of the added mass, or none."));
      if (!section.given(e.added_mass))
        return;
      AddedMass mass;
      mass.boundaries  = section.list(e.added_mass);
      mass.level       = section.value(e.level);
      mass.bottom      = section.value(e.bottom);
      mass.unit_weight = section.value(e.unit_weight);
      mass.origin      = section.origin(e.added_mass);
      if (mass.level <= mass.bottom)
        section.fail(e.level,
                     fmt::format("the water has no depth: its bottom is at {:g} ({}). The level is "
                                 "above it.",
                                 mass.bottom,
                                 section.origin(e.bottom)));
      dynamics.added_masses.push_back(std::move(mass));
    }
  } // namespace


  void
  read_earthquake(const ParameterValues &values, Parameters &parameters)
  {
    const ParameterSection section = values.section<EarthquakeEntries>();
    if (!has_dynamic_stage(parameters.model))
      refuse_without_motion(section);
    bool is_wanted = false;
    section.for_given([&is_wanted](const AnyEntry &entry) {
      is_wanted = is_wanted || entry.declaration->presence == Presence::optional;
    });
    if (!is_wanted)
      return;
    DynamicsDefinition &dynamics = parameters.model.dynamics;
    section.read(dynamics);
    dynamics.earthquake_stage = read_stage(section, parameters.model.stages);
    read_ground(section, parameters, dynamics);
    read_base(section, dynamics);
    read_free_field(section, parameters.model, dynamics);
    read_added_mass(section, dynamics);
  }
} // namespace fuga
