// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace fuga
{
  namespace
  {
    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }


    LoadKind
    read_kind(const ParameterSection &section)
    {
      const std::string type = section.text("Type");
      return type == "weight"        ? LoadKind::weight
             : type == "pressure"    ? LoadKind::pressure
             : type == "traction"    ? LoadKind::traction
             : type == "point force" ? LoadKind::point_force
                                     : LoadKind::displacement;
    }


    /** The entry that says where a load acts. */
    std::string
    target_entry(const LoadKind kind)
    {
      return kind == LoadKind::weight        ? "Bodies"
             : kind == LoadKind::point_force ? "Point"
                                             : "Boundaries";
    }


    void
    read_targets(const ParameterSection &section,
                 const ModelDefinition &model,
                 LoadDefinition &load)
    {
      const std::string wanted = target_entry(load.kind);
      for (const char *const entry : {"Bodies", "Boundaries", "Point"})
        if (section.given(entry) && entry != wanted)
          section.fail(entry,
                       fmt::format("a load of type {} ({}) has no such entry. {}",
                                   section.text("Type"),
                                   section.origin("Type"),
                                   "It acts on what '" + wanted + "' says; remove this line."));
      if (load.kind != LoadKind::weight && !section.given(wanted))
        section.fail(
          fmt::format("'{}' is missing: say where this {} acts.", wanted, section.text("Type")));
      if (load.kind == LoadKind::point_force)
        {
          const PointReference point = read_point(section, model.dimension);
          load.has_coordinates       = point.name.empty();
          load.coordinates           = point.coordinates;
          if (!point.name.empty())
            load.targets = {point.name};
        }
      else
        load.targets = section.list(wanted);
    }


    /** Whether Bodies are known and weigh anything. */
    void
    check_weight(const ParameterSection &section,
                 const ModelDefinition &model,
                 const LoadDefinition &load)
    {
      std::vector<std::string> bodies;
      bool has_weight = false;
      for (const Material &material : model.materials)
        {
          bodies.push_back(material.body);
          has_weight = has_weight || material.weight_density > 0.;
          if (contains(load.targets, material.body) && material.weight_density == 0.)
            section.fail(
              "Bodies",
              fmt::format("body '{}' has weight density 0, so that this load does nothing to "
                          "it. Set Bodies/{}/Weight density, or take the body out of the "
                          "list.",
                          material.body,
                          material.body));
        }
      for (const std::string &body : load.targets)
        if (!contains(bodies, body))
          section.fail("Bodies",
                       fmt::format("there is no body '{}' in section Bodies. {}",
                                   body,
                                   name_hint(body, bodies, "bodies")));
      if (!has_weight)
        section.fail("no body has a weight density, so that this load does nothing. Set 'Weight "
                     "density' of the bodies, or remove the load.");
    }


    std::vector<std::string>
    read_expressions(const ParameterSection &section,
                     const ModelDefinition &model,
                     const LoadKind kind)
    {
      if (!section.given("Value"))
        {
          if (kind != LoadKind::weight)
            section.fail(
              fmt::format("'Value' is missing: say how large this {} is.", section.text("Type")));
          return {"0", "-1"};
        }
      const std::vector<std::string> expressions = split_pieces(section.text("Value"), ';');
      const std::size_t n                        = kind == LoadKind::pressure ? 1 : model.dimension;
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
            check_expression(
              section, "Value", expression, ExpressionArguments::place_and_time, model.constants);
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
      LoadDefinition load;
      load.name   = section.name();
      load.kind   = read_kind(section);
      load.origin = section.origin();
      read_targets(section, model, load);
      if (load.kind == LoadKind::weight)
        check_weight(section, model, load);
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
      loads.push_back(read_load(section, model));
    return loads;
  }


  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<StageDefinition> stages;
    for (const ParameterSection &section : values.subsections("Stages"))
      stages.push_back(read_stage(section, model));
    return stages;
  }
} // namespace fuga
