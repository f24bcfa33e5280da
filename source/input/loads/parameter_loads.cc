// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fuga
{
  namespace
  {
    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }


    std::string
    lower_case(std::string word)
    {
      word.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(word.front())));
      return word;
    }


    /** The entries that belong to a type of load. */
    struct TypeEntries
    {
      LoadType type;
      LoadKind kind;
      std::vector<AnyEntry> required, optional;
    };


    const std::vector<TypeEntries> &
    load_types()
    {
      using T                                     = LoadType;
      using K                                     = LoadKind;
      static const LoadEntries &e                 = entries_of<LoadEntries>();
      static const std::vector<TypeEntries> types = {
        {T::weight, K::weight, {}, {e.bodies, e.value}},
        {T::seismic,
         K::weight,
         {},
         {e.bodies, e.horizontal_coefficient, e.horizontal_direction, e.vertical_coefficient}},
        {T::temperature, K::temperature, {e.value}, {e.bodies}},
        {T::pressure, K::pressure, {e.boundaries, e.value}, {}},
        {T::hydrostatic, K::depth_pressure, {e.boundaries, e.level, e.unit_weight}, {}},
        {T::earth_pressure,
         K::depth_pressure,
         {e.boundaries, e.level, e.unit_weight, e.earth_coefficient},
         {e.surcharge}},
        {T::westergaard,
         K::depth_pressure,
         {e.boundaries, e.level, e.unit_weight, e.horizontal_coefficient, e.bottom_level},
         {}},
        {T::uplift,
         K::uplift,
         {e.joints, e.level, e.unit_weight},
         {e.upstream_end,
          e.flow_direction,
          e.profile_from,
          e.tailwater_level,
          e.drain_distance,
          e.drain_efficiency,
          e.drains_after_crack,
          e.pressure_profile,
          e.cracks}},
        {T::traction, K::traction, {e.boundaries, e.value}, {}},
        {T::point_force, K::point_force, {e.point, e.value}, {}},
        {T::displacement, K::displacement, {e.boundaries, e.value}, {}},
        {T::imposed_gap, K::imposed_gap, {e.joints, e.value}, {}}};
      return types;
    }


    /** Read the type of a load, all of whose entries have to be given, and no others. */
    const TypeEntries &
    read_type(const ParameterSection &section)
    {
      const LoadEntries &e   = entries_of<LoadEntries>();
      const std::string name = section.text(e.type);
      const TypeEntries &type =
        *std::find_if(load_types().begin(), load_types().end(), [&](const TypeEntries &t) {
          return t.type == section.value(e.type);
        });
      std::vector<std::string> known;
      for (const auto *const entries : {&type.required, &type.optional})
        for (const AnyEntry &entry : *entries)
          known.push_back(entry.name());
      section.for_given([&](const AnyEntry &entry) {
        if (!(entry == e.type) && !contains(known, entry.name()))
          section.fail(entry,
                       fmt::format("a load of type {} ({}) has no such entry; it has {}. Remove "
                                   "this line, or correct the type.",
                                   name,
                                   section.origin(e.type),
                                   quoted_list(known)));
      });
      for (const AnyEntry &entry : type.required)
        if (!section.given(entry))
          section.fail(fmt::format("'{}' is missing, which a load of type {} needs. {}",
                                   entry.name(),
                                   name,
                                   entry.declaration->documentation));
      return type;
    }


    void
    read_targets(const ParameterSection &section,
                 const ModelDefinition &model,
                 LoadDefinition &load)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (load.kind == LoadKind::point_force)
        {
          const PointReference point = read_point(section, e.point, model.dimension);
          load.has_coordinates       = point.name.empty();
          load.coordinates           = point.coordinates;
          if (!point.name.empty())
            load.targets = {point.name};
        }
      else if (load.kind == LoadKind::weight || load.kind == LoadKind::temperature)
        load.targets = section.list(e.bodies);
      else
        load.targets = section.list(
          load.kind == LoadKind::uplift || load.kind == LoadKind::imposed_gap ? e.joints
                                                                              : e.boundaries);
    }


    /** Check that Bodies are known, and have the property (of that entry) through which they are
     * loaded. */
    void
    check_bodies(const ParameterSection &section,
                 const ModelDefinition &model,
                 const LoadDefinition &load,
                 const AnyEntry &entry,
                 double Material::*property)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      std::vector<std::string> bodies;
      bool any               = false;
      const std::string word = lower_case(entry.name());
      for (const Material &material : model.materials)
        {
          bodies.push_back(material.body);
          any = any || material.*property > 0.;
          if (contains(load.targets, material.body) && material.*property == 0.)
            section.fail(e.bodies,
                         fmt::format("body '{}' has {} 0, so that this load does nothing to it. "
                                     "Set Bodies/{}/{}, or take the body out of the list.",
                                     material.body,
                                     word,
                                     material.body,
                                     entry.name()));
        }
      for (const std::string &body : load.targets)
        number_of(body, bodies, "body", section, e.bodies);
      if (!any)
        section.fail(
          fmt::format("no body has a {}, so that this load does nothing. Set '{}' of the "
                      "bodies, or remove the load.",
                      word,
                      entry.name()));
    }


    std::vector<std::string>
    read_expressions(const ParameterSection &section,
                     const ModelDefinition &model,
                     const LoadKind kind)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (!section.given(e.value))
        return model.dimension == 2 ? std::vector<std::string>{"0", "-1"}
                                    : std::vector<std::string>{"0", "0", "-1"}; // a weight
      const std::vector<std::string> expressions = split_pieces(section.text(e.value), ';');
      const bool is_scalar = kind == LoadKind::pressure || kind == LoadKind::temperature ||
                             kind == LoadKind::imposed_gap;
      const std::size_t n = is_scalar ? 1 : model.dimension;
      if (expressions.size() != n)
        section.fail(
          e.value,
          fmt::format("{} expression(s) separated by ';' instead of {}: a {} in {} dimensions "
                      "has {}.",
                      expressions.size(),
                      n,
                      section.text(e.type),
                      model.dimension,
                      n == 1 ? "one value" : "one per component"));
      bool all_empty = true;
      for (const std::string &expression : expressions)
        if (!expression.empty())
          {
            all_empty = false;
            check_expression(section,
                             e.value,
                             expression,
                             model.dimension == 2 ? ExpressionArguments::place_and_time
                                                  : ExpressionArguments::place_in_space_and_time,
                             model.constants);
          }
        else if (kind != LoadKind::displacement)
          section.fail(e.value, "an expression is empty. Write 0 for a component without load.");
      if (all_empty)
        section.fail(e.value, "all components are empty. Prescribe one at least.");
      return expressions;
    }


    LoadDefinition
    read_load(const ParameterSection &section, const ModelDefinition &model)
    {
      const TypeEntries &type = read_type(section);
      LoadDefinition load;
      load.name   = section.name();
      load.kind   = type.kind;
      load.origin = section.origin();
      read_targets(section, model, load);
      if (load.kind == LoadKind::weight)
        check_bodies(section,
                     model,
                     load,
                     entries_of<BodyEntries>().weight_density,
                     &Material::weight_density);
      if (load.kind == LoadKind::temperature)
        check_bodies(section,
                     model,
                     load,
                     entries_of<BodyEntries>().thermal_expansion,
                     &Material::thermal_expansion);
      if (load.has_level())
        load.depth = read_depth_pressure(section, model.constants);
      if (load.kind == LoadKind::uplift)
        load.uplift = read_uplift(section, model);
      if (type.type == LoadType::seismic)
        load.expressions = read_seismic_coefficients(section, model.dimension);
      else if (!load.has_level())
        load.expressions = read_expressions(section, model, load.kind);
      return load;
    }


    StageDefinition::History
    read_history(const ParameterSection &section,
                 const std::string &piece,
                 const ModelDefinition &model)
    {
      const StageEntries &e   = entries_of<StageEntries>();
      const std::size_t colon = piece.find(':');
      const std::string name  = normalise_blanks(piece.substr(0, colon));
      if (colon == std::string::npos)
        section.fail(e.loads,
                     fmt::format("'{}' has no ':'. Write 'LOAD: FACTOR', for example '{}: t'.",
                                 piece,
                                 name.empty() ? "weight" : name));
      std::vector<std::string> names;
      for (const LoadDefinition &load : model.loads)
        names.push_back(load.name);
      const unsigned int load      = number_of(name, names, "load", section, e.loads);
      const std::string expression = normalise_blanks(piece.substr(colon + 1));
      if (expression.empty())
        section.fail(e.loads,
                     fmt::format("'{}:' has no factor. Write for example '{}: t'.", name, name));
      check_expression(
        section, e.loads, expression, ExpressionArguments::stage_fraction, model.constants);
      return {load, expression};
    }


    StageDefinition
    read_stage(const ParameterSection &section, const ModelDefinition &model)
    {
      const StageEntries &e = entries_of<StageEntries>();
      StageDefinition stage;
      stage.name   = section.name();
      stage.origin = section.origin();
      section.read(stage);
      stage.keeps_water = stage.keeps_water || stage.is_dynamic();
      for (const std::string &piece : split_pieces(section.text(e.loads), ';'))
        {
          if (piece.empty())
            section.fail(e.loads, "an item of the list is empty. Remove the ';' that is too many.");
          const StageDefinition::History history = read_history(section, piece, model);
          for (const StageDefinition::History &other : stage.histories)
            if (other.load == history.load)
              section.fail(e.loads,
                           fmt::format("load '{}' is in the list twice. Unite the two factors.",
                                       model.loads[history.load].name));
          stage.histories.push_back(history);
        }
      return stage;
    }
  } // namespace


  std::vector<LoadDefinition>
  read_loads(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<LoadDefinition> loads;
    for (const ParameterSection &section : values.subsections<LoadEntries>())
      {
        loads.emplace_back();
        loads.back().name = section.name();
        if (!values.is_broken<BodyEntries>())
          values.attempt(section, [&]() { loads.back() = read_load(section, model); });
      }
    return loads;
  }


  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<StageDefinition> stages;
    for (const ParameterSection &section : values.subsections<StageEntries>())
      {
        stages.emplace_back();
        values.attempt(section, [&]() { stages.back() = read_stage(section, model); });
      }
    return stages;
  }
} // namespace fuga
