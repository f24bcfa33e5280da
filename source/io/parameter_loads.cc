// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_declarations.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>

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


    /** A word of Type with the entries that belong to it. */
    struct LoadType
    {
      std::string name;
      LoadKind kind;
      std::vector<std::string> required, optional;
    };


    const std::vector<LoadType> &
    load_types()
    {
      static const std::vector<LoadType> types = {
        {"weight", LoadKind::weight, {}, {"Bodies", "Value"}},
        {"seismic",
         LoadKind::weight,
         {},
         {"Bodies", "Horizontal coefficient", "Horizontal direction", "Vertical coefficient"}},
        {"temperature", LoadKind::temperature, {"Value"}, {"Bodies"}},
        {"pressure", LoadKind::pressure, {"Boundaries", "Value"}, {}},
        {"hydrostatic", LoadKind::depth_pressure, {"Boundaries", "Level", "Unit weight"}, {}},
        {"earth pressure",
         LoadKind::depth_pressure,
         {"Boundaries", "Level", "Unit weight", "Earth pressure coefficient"},
         {"Surcharge"}},
        {"westergaard",
         LoadKind::depth_pressure,
         {"Boundaries", "Level", "Unit weight", "Horizontal coefficient", "Bottom level"},
         {}},
        {"uplift",
         LoadKind::uplift,
         {"Joints", "Level", "Unit weight"},
         {"Upstream end",
          "Flow direction",
          "Profile from",
          "Tailwater level",
          "Drain distance",
          "Drain efficiency",
          "Drains after crack",
          "Pressure profile",
          "Cracks"}},
        {"traction", LoadKind::traction, {"Boundaries", "Value"}, {}},
        {"point force", LoadKind::point_force, {"Point", "Value"}, {}},
        {"displacement", LoadKind::displacement, {"Boundaries", "Value"}, {}},
        {"imposed gap", LoadKind::imposed_gap, {"Joints", "Value"}, {}}};
      return types;
    }


    /** The type of a load, whose entries are all there, and no others. */
    const LoadType &
    read_type(const ParameterSection &section)
    {
      const std::string name         = section.text("Type");
      const LoadType &type           = *std::find_if(load_types().begin(),
                                           load_types().end(),
                                           [&](const LoadType &t) { return t.name == name; });
      std::vector<std::string> known = type.required;
      known.insert(known.end(), type.optional.begin(), type.optional.end());
      const SectionDeclaration &declared = *find_section("Loads");
      for (const std::string &entry : declared.entry_names())
        if (entry != "Type" && section.given(entry) && !contains(known, entry))
          section.fail(entry,
                       fmt::format("a load of type {} ({}) has no such entry; it has {}. Remove "
                                   "this line, or correct the type.",
                                   name,
                                   section.origin("Type"),
                                   quoted_list(known)));
      for (const std::string &entry : type.required)
        if (!section.given(entry))
          section.fail(fmt::format("'{}' is missing, which a load of type {} needs. {}",
                                   entry,
                                   name,
                                   declared.find(entry)->documentation));
      return type;
    }


    void
    read_targets(const ParameterSection &section,
                 const ModelDefinition &model,
                 LoadDefinition &load)
    {
      if (load.kind == LoadKind::point_force)
        {
          const PointReference point = read_point(section, model.dimension);
          load.has_coordinates       = point.name.empty();
          load.coordinates           = point.coordinates;
          if (!point.name.empty())
            load.targets = {point.name};
        }
      else if (load.kind == LoadKind::weight || load.kind == LoadKind::temperature)
        load.targets = section.list("Bodies");
      else
        load.targets = section.list(
          load.kind == LoadKind::uplift || load.kind == LoadKind::imposed_gap ? "Joints"
                                                                              : "Boundaries");
    }


    /** Whether Bodies are known, and have the property (of that entry) through which they are
     * loaded.
     */
    void
    check_bodies(const ParameterSection &section,
                 const ModelDefinition &model,
                 const LoadDefinition &load,
                 const std::string &entry,
                 double Material::*property)
    {
      std::vector<std::string> bodies;
      bool any               = false;
      const std::string word = lower_case(entry);
      for (const Material &material : model.materials)
        {
          bodies.push_back(material.body);
          any = any || material.*property > 0.;
          if (contains(load.targets, material.body) && material.*property == 0.)
            section.fail("Bodies",
                         fmt::format("body '{}' has {} 0, so that this load does nothing to it. "
                                     "Set Bodies/{}/{}, or take the body out of the list.",
                                     material.body,
                                     word,
                                     material.body,
                                     entry));
        }
      for (const std::string &body : load.targets)
        if (!contains(bodies, body))
          section.fail("Bodies",
                       fmt::format("there is no body '{}' in section Bodies. {}",
                                   body,
                                   name_hint(body, bodies, "bodies")));
      if (!any)
        section.fail(
          fmt::format("no body has a {}, so that this load does nothing. Set '{}' of the "
                      "bodies, or remove the load.",
                      word,
                      entry));
    }


    std::vector<std::string>
    read_expressions(const ParameterSection &section,
                     const ModelDefinition &model,
                     const LoadKind kind)
    {
      if (!section.given("Value"))
        return model.dimension == 2 ? std::vector<std::string>{"0", "-1"}
                                    : std::vector<std::string>{"0", "0", "-1"}; // a weight
      const std::vector<std::string> expressions = split_pieces(section.text("Value"), ';');
      const bool is_scalar = kind == LoadKind::pressure || kind == LoadKind::temperature ||
                             kind == LoadKind::imposed_gap;
      const std::size_t n = is_scalar ? 1 : model.dimension;
      if (expressions.size() != n)
        section.fail(
          "Value",
          fmt::format("{} expression(s) separated by ';' instead of {}: a {} in {} dimensions "
                      "has {}.",
                      expressions.size(),
                      n,
                      section.text("Type"),
                      model.dimension,
                      n == 1 ? "one value" : "one per component"));
      bool all_empty = true;
      for (const std::string &expression : expressions)
        if (!expression.empty())
          {
            all_empty = false;
            check_expression(section,
                             "Value",
                             expression,
                             model.dimension == 2 ? ExpressionArguments::place_and_time
                                                  : ExpressionArguments::place_in_space_and_time,
                             model.constants);
          }
        else if (kind != LoadKind::displacement)
          section.fail("Value", "an expression is empty. Write 0 for a component without load.");
      if (all_empty)
        section.fail("Value", "all components are empty. Prescribe one at least.");
      return expressions;
    }


    LoadDefinition
    read_load(const ParameterSection &section, const ModelDefinition &model)
    {
      const LoadType &type = read_type(section);
      LoadDefinition load;
      load.name   = section.name();
      load.kind   = type.kind;
      load.origin = section.origin();
      read_targets(section, model, load);
      if (load.kind == LoadKind::weight)
        check_bodies(section, model, load, "Weight density", &Material::weight_density);
      if (load.kind == LoadKind::temperature)
        check_bodies(section, model, load, "Thermal expansion", &Material::thermal_expansion);
      if (load.has_level())
        load.depth = read_depth_pressure(section, model.constants);
      if (load.kind == LoadKind::uplift)
        load.uplift = read_uplift(section, model);
      if (type.name == "seismic")
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
      const std::size_t colon = piece.find(':');
      const std::string name  = normalise_blanks(piece.substr(0, colon));
      if (colon == std::string::npos)
        section.fail("Loads",
                     fmt::format("'{}' has no ':'. Write 'LOAD: FACTOR', for example '{}: t'.",
                                 piece,
                                 name.empty() ? "weight" : name));
      std::vector<std::string> names;
      for (const LoadDefinition &load : model.loads)
        names.push_back(load.name);
      const auto known = std::find(names.begin(), names.end(), name);
      if (known == names.end())
        section.fail("Loads",
                     fmt::format("there is no load '{}' in section Loads. {}",
                                 name,
                                 name_hint(name, names, "loads")));
      const std::string expression = normalise_blanks(piece.substr(colon + 1));
      if (expression.empty())
        section.fail("Loads",
                     fmt::format("'{}:' has no factor. Write for example '{}: t'.", name, name));
      check_expression(
        section, "Loads", expression, ExpressionArguments::stage_fraction, model.constants);
      return {static_cast<unsigned int>(known - names.begin()), expression};
    }


    StageDefinition
    read_stage(const ParameterSection &section, const ModelDefinition &model)
    {
      StageDefinition stage;
      stage.name   = section.name();
      stage.origin = section.origin();
      stage.levels = section.integer("Levels");
      stage.keeps_water =
        section.given("Water in joints") && section.text("Water in joints") == "unchanged";
      for (const std::string &piece : split_pieces(section.text("Loads"), ';'))
        {
          if (piece.empty())
            section.fail("Loads", "an item of the list is empty. Remove the ';' that is too many.");
          const StageDefinition::History history = read_history(section, piece, model);
          for (const StageDefinition::History &other : stage.histories)
            if (other.load == history.load)
              section.fail("Loads",
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
    for (const ParameterSection &section : values.subsections("Loads"))
      {
        loads.emplace_back();
        loads.back().name = section.name();
        if (!values.is_broken("Bodies"))
          values.attempt(section, [&]() { loads.back() = read_load(section, model); });
      }
    return loads;
  }


  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<StageDefinition> stages;
    for (const ParameterSection &section : values.subsections("Stages"))
      {
        stages.emplace_back();
        values.attempt(section, [&]() { stages.back() = read_stage(section, model); });
      }
    return stages;
  }
} // namespace fuga
