// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed/model_sizes.h>
#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/joints/joint_corners.h>
#include <fuga/bodies/loads/level_history.h>
#include <fuga/output/files/text_table.h>
#include <fuga/output/warnings/model_echo.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    constexpr std::array<const char *, 3> axis_names = {{"x", "y", "z"}};

    void
    append(std::vector<std::string> &lines, const std::vector<std::string> &more)
    {
      lines.insert(lines.end(), more.begin(), more.end());
    }

    /** Return a title and the table under it; nothing without rows. */
    std::vector<std::string>
    titled(const std::string &title, const TextTable &table)
    {
      if (table.is_empty())
        return {};
      std::vector<std::string> lines = {title};
      append(lines, table.lines());
      return lines;
    }

    template <int dim>
    std::string
    point_cells(const dealii::Tensor<1, dim> &vector, const double scale)
    {
      std::string text;
      for (unsigned int c = 0; c < dim; ++c)
        text += (c == 0 ? "" : ", ") + readable(vector[c], scale);
      return text;
    }
  } // namespace


  template <int dim>
  ModelEcho<dim>::ModelEcho(const Parameters &run_parameters,
                            const CondensedSystem<dim> &bodies,
                            const LoadHistory &factors,
                            const unsigned int first,
                            const unsigned int end)
    : parameters(run_parameters)
    , model(parameters.model)
    , system(bodies)
    , load_factors(factors)
    , first_stage(first)
    , end_stage(end)
    , is_flat(dim == 2 && !system.discretization().is_axisymmetric())
  {
    const auto [low, high] = extent_of(system.discretization());
    for (unsigned int c = 0; c < dim; ++c)
      extent = std::max(extent, high[c] - low[c]);
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::in_full() const
  {
    Lines lines = bodies();
    append(lines, joints());
    append(lines, supports());
    for (unsigned int stage = first_stage; stage < end_stage; ++stage)
      if (model.stages[stage].purpose == StagePurpose::loading)
        append(lines, loads(stage));
    return lines;
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::in_brief() const
  {
    Lines lines = bodies();
    for (unsigned int stage = end_stage; stage-- > first_stage;)
      if (model.stages[stage].purpose == StagePurpose::loading)
        {
          append(lines, loads(stage));
          break;
        }
    return lines;
  }


  template <int dim>
  std::string
  ModelEcho<dim>::measure_of_faces() const
  {
    const Units &units = parameters.output.units;
    return is_flat ? fmt::format("length [{}]", units.length)
                   : fmt::format("area [{}]", units.area());
  }


  template <int dim>
  std::string
  ModelEcho<dim>::measure_of_bodies() const
  {
    const Units &units = parameters.output.units;
    return is_flat ? fmt::format("area [{}]", units.area())
                   : fmt::format("volume [{}]", units.volume());
  }


  template <int dim>
  bool
  ModelEcho<dim>::is_weighed(const std::string &body) const
  {
    return std::any_of(model.loads.begin(), model.loads.end(), [&](const LoadDefinition &load) {
      return load.kind == LoadKind::weight &&
             (load.targets.empty() || index_of(load.targets, body) < load.targets.size());
    });
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::bodies() const
  {
    const Units &units      = parameters.output.units;
    const JointedMesh &mesh = system.jointed_mesh();
    const auto sizes        = body_sizes(system.discretization(), mesh);
    const double thickness  = is_flat ? model.thickness : 1.;
    const std::string extent_across =
      thickness == 1. ? "" : fmt::format(" (weight of {:g} {} thickness)", thickness, units.length);
    TextTable table({"body",
                     measure_of_bodies(),
                     "cells",
                     fmt::format("weight [{}]", units.force),
                     fmt::format("centroid {} [{}]", dim == 2 ? "x, y" : "x, y, z", units.length)});
    for (const Material &material : model.materials)
      {
        const auto &size = sizes[index_of(mesh.body_names, material.body)];
        if (size.n_cells > 0)
          table.add(
            {material.body,
             readable(size.volume / thickness),
             std::to_string(size.n_cells),
             readable(is_weighed(material.body) ? size.volume * material.weight_density : 0.),
             point_cells<dim>(size.centroid, extent)});
      }
    return titled("Bodies" + extent_across, table);
  }


  template <int dim>
  double
  ModelEcho<dim>::largest_initial_gap(const unsigned int joint) const
  {
    const JointParameters &data = parameters.joints[joint];
    const FieldExpression<dim> gap({data.initial_gap}, model.constants, data.origin);
    double largest = 0.;
    for (const ContactElement &element : system.elements())
      if (element.joint == joint)
        {
          dealii::Point<dim> place;
          for (unsigned int c = 0; c < dim; ++c)
            place[c] = element.position[c];
          largest = std::max(largest, gap.value(place, 0));
        }
    return largest;
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::joints() const
  {
    const std::string &unit = parameters.output.units.length;
    const auto sizes =
      joint_sizes(system.discretization(), system.joint_geometry(), parameters.joints.size());
    std::vector<std::size_t> n_elements(sizes.size(), 0);
    for (const ContactElement &element : system.elements())
      ++n_elements[element.joint];
    TextTable table({"joint",
                     measure_of_faces(),
                     "elements",
                     fmt::format("distance of sides [{}]", unit),
                     fmt::format("initial gap [{}]", unit),
                     "mean normal"});
    for (unsigned int j = 0; j < sizes.size(); ++j)
      if (sizes[j].n_faces > 0)
        table.add({parameters.joints[j].definition.name,
                   readable(sizes[j].area / (is_flat ? model.thickness : 1.)),
                   std::to_string(n_elements[j]),
                   readable(sizes[j].distance, extent),
                   readable(largest_initial_gap(j), extent),
                   point_cells<dim>(sizes[j].normal, 1.)});
    Lines lines = titled("Joints (largest distances and gaps of the undeformed model)", table);
    append(lines, corner_report(system.joint_geometry().pairs(), system.jointed_mesh()));
    return lines;
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::supports() const
  {
    const Discretization<dim> &space = system.discretization();
    const JointedMesh &mesh          = system.jointed_mesh();
    TextTable table({"support", "held", measure_of_faces(), "nodes"});
    for (const BoundaryCondition &condition : model.boundary_conditions)
      {
        std::string held;
        for (unsigned int c = 0; c < dim; ++c)
          if (condition.fixed[c])
            held += (held.empty() ? "" : ", ") + std::string(axis_names[c]);
        const std::size_t n_nodes = nodes_of_target(space, mesh, condition.boundary).size();
        if (held.empty() || n_nodes == 0)
          continue;
        const unsigned int label = index_of(mesh.label_names, condition.boundary);
        const bool is_point      = label == mesh.label_names.size();
        table.add({condition.boundary,
                   held,
                   is_point
                     ? "point"
                     : readable(boundary_area(space, label) / (is_flat ? model.thickness : 1.)),
                   std::to_string(n_nodes)});
      }
    return titled("Supports", table);
  }


  template <int dim>
  auto
  ModelEcho<dim>::actions(const std::size_t number, const double t) const -> std::vector<Action>
  {
    const LoadDefinition &load = model.loads[number];
    const LoadPattern pattern  = system.assemble_load(number, t);
    if (load.kind != LoadKind::uplift)
      return {{load.name, resultant_of(system.discretization(), pattern.forces), false}};
    std::vector<Action> result;
    for (unsigned int j = 0; j < parameters.joints.size(); ++j)
      if (const std::string &joint = parameters.joints[j].definition.name;
          index_of(load.targets, joint) < load.targets.size())
        result.push_back({fmt::format("{} in {}", load.name, joint),
                          resultant_of_water(system, j, pattern.closed_water),
                          true});
    return result;
  }


  template <int dim>
  void
  ModelEcho<dim>::add_rows(const Action &action,
                           const std::vector<std::string> &first_cells,
                           TextTable &table) const
  {
    std::vector<std::string> row = first_cells;
    const auto add               = [&](std::string component, const double value) {
      row.push_back(std::move(component));
      row.push_back(readable(value));
    };
    bool any = false;
    for (unsigned int c = 0; c < dim; ++c)
      {
        // Around the whole axis the radial forces are in balance.
        const bool round   = system.discretization().is_axisymmetric();
        const double force = round && c == 0 ? 0. : action.resultant.force(c);
        if (force == 0.)
          continue;
        add(fmt::format("F{}", axis_names[c]), force);
        for (unsigned int d = 0; d < dim; ++d)
          row.push_back(c == d ? "" : readable(round ? 0. : action.resultant.place(c, d), extent));
        table.add(std::move(row));
        row.assign(first_cells.size(), "");
        any = true;
      }
    const std::array<double, 3> couple = action.resultant.couple();
    for (unsigned int c = 0; c < 3; ++c)
      if (couple[c] != 0. && !system.discretization().is_axisymmetric())
        {
          add(fmt::format("M{}", axis_names[c]), couple[c]);
          table.add(std::move(row));
          row.assign(first_cells.size(), "");
          any = true;
        }
    if (!any)
      {
        row.push_back(action.resultant.is_empty() ? "no force" : "in balance");
        table.add(std::move(row));
      }
  }


  template <int dim>
  std::vector<std::string>
  ModelEcho<dim>::loads(const unsigned int stage) const
  {
    const Units &units                = parameters.output.units;
    const double t                    = stage + 1.;
    const Vector factors              = load_factors.factors(t);
    std::vector<std::string> headings = {"load",
                                         "factor",
                                         fmt::format("level [{}]", units.length),
                                         "",
                                         fmt::format("force [{}]", units.force)};
    for (unsigned int c = 0; c < dim; ++c)
      headings.push_back(fmt::format("at {} [{}]", axis_names[c], units.length));
    TextTable table(std::move(headings));
    Action all{"all, without water in joints", {}, false};
    unsigned int n_outer = 0;
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (factors[i] != 0.)
        for (Action &action : actions(i, t))
          {
            const LoadDefinition &load = model.loads[i];
            action.resultant.scale(factors[i]);
            std::string level;
            if (load.has_level())
              level = readable(LevelHistory(load, model.constants)(t), extent);
            if (load.uplift.has_tailwater)
              level +=
                " / " +
                readable(LevelHistory(load.uplift.tailwater, load, model.constants)(t), extent);
            add_rows(action, {action.name, readable(factors[i]), level}, table);
            if (!action.is_inner)
              {
                all.resultant.add(action.resultant);
                n_outer += action.resultant.is_empty() ? 0 : 1;
              }
          }
    if (n_outer > 1)
      add_rows(all, {all.name, "", ""}, table);
    return titled(
      fmt::format("Loads at the end of stage '{}' (t = {:g})", model.stages[stage].name, t), table);
  }


  template class ModelEcho<2>;
  template class ModelEcho<3>;
} // namespace fuga
