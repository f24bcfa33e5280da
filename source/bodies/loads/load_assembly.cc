// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/cell_values.h>
#include <fuga/bodies/space/face_map.h>

#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the expressions with their defaults, and check their number. */
    std::vector<std::string>
    checked_expressions(const LoadDefinition &load, const unsigned int dim)
    {
      if (load.kind == LoadKind::weight && load.expressions.empty())
        return dim == 2 ? std::vector<std::string>{"0", "-1"}
                        : std::vector<std::string>{"0", "0", "-1"};
      const bool is_scalar = load.kind == LoadKind::pressure ||
                             load.kind == LoadKind::temperature ||
                             load.kind == LoadKind::imposed_gap;
      const std::size_t expected = load.kind == LoadKind::depth_pressure ? 0 : is_scalar ? 1 : dim;
      if (load.expressions.size() != expected)
        throw InputError(fmt::format("{}: it has {} expressions and needs {}.",
                                     load_title(load),
                                     load.expressions.size(),
                                     expected));
      const bool on_bodies = load.kind == LoadKind::weight || load.kind == LoadKind::temperature;
      if (load.targets.empty() && !on_bodies && !load.has_coordinates)
        throw InputError(fmt::format("{}: it acts nowhere; name its targets.", load_title(load)));
      return load.expressions;
    }
  } // namespace


  std::string
  load_title(const LoadDefinition &load)
  {
    return fmt::format("{}Load '{}'", load.origin.empty() ? "" : load.origin + ": ", load.name);
  }


  bool
  depends_on_time(const LoadDefinition &load)
  {
    for (const auto &expression : load.expressions)
      if (expression_uses(expression, "t"))
        return true;
    return load.has_level() &&
           (level_changes(load.depth) ||
            (load.uplift.has_tailwater && level_changes(load.uplift.tailwater)));
  }


  template <int dim>
  LoadAssembly<dim>::LoadAssembly(const Discretization<dim> &space,
                                  const JointedMesh &jointed,
                                  const ModelDefinition &model_definition,
                                  const std::vector<bool> &fixed_dofs)
    : discretization(space), mesh(jointed), model(model_definition), fixed(fixed_dofs)
  {
  }


  template <int dim>
  LoadPattern
  LoadAssembly<dim>::assemble(const LoadDefinition &load, const double t) const
  {
    FieldExpression<dim> field(checked_expressions(load, dim), model.constants, load_title(load));
    field.set_time(t);
    LoadPattern pattern;
    pattern.forces.assign(discretization.n_dofs(), 0.);
    switch (load.kind)
      {
        case LoadKind::weight:
          add_weight(load, field, pattern.forces);
          break;
        case LoadKind::temperature:
          add_temperature(load, t, pattern.forces);
          break;
        case LoadKind::depth_pressure:
          add_depth_pressure(discretization,
                             load.depth,
                             LevelHistory(load, model.constants)(t),
                             selection(mesh.label_names, load.targets),
                             pattern.forces);
          break;
        case LoadKind::uplift: // handled by UpliftAssembly
          break;
        case LoadKind::pressure:
        case LoadKind::traction:
          add_surface_load(load, field, pattern.forces);
          break;
        case LoadKind::point_force:
          add_point_force(load, field, pattern.forces);
          break;
        case LoadKind::displacement:
          pattern.prescribed.assign(discretization.n_dofs(), 0.);
          set_displacement(load, field, pattern.prescribed);
          break;
        case LoadKind::imposed_gap:
          break; // no force, and joints are not known here
      }
    return pattern;
  }


  template <int dim>
  void
  LoadAssembly<dim>::add_weight(const LoadDefinition &load,
                                const FieldExpression<dim> &direction,
                                Vector &forces) const
  {
    Vector density(mesh.body_names.size(), 0.);
    for (const Material &material : model.materials)
      if (load.targets.empty() || index_of(load.targets, material.body) < load.targets.size())
        density[index_of(mesh.body_names, material.body)] = material.weight_density;

    dealii::Tensor<1, dim> uniform;
    if (direction.is_uniform())
      for (unsigned int c = 0; c < dim; ++c)
        uniform[c] = direction.value(dealii::Point<dim>(), c);

    const std::size_t n_local = discretization.reference_element().n_nodes();
    CellValues<dim> values(discretization);
    Vector share(n_local);
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        const double specific = density[discretization.cell_body(cell)];
        if (specific == 0.)
          continue;
        const unsigned int *nodes = discretization.cell_nodes(cell);
        if (values.move_to(cell))
          {
            std::fill(share.begin(), share.end(), 0.);
            for (std::size_t q = 0; q < values.n_points(); ++q)
              for (std::size_t i = 0; i < n_local; ++i)
                share[i] += values.volume(q) * values.value(i, q);
          }
        if (direction.is_uniform())
          for (std::size_t i = 0; i < n_local; ++i)
            for (unsigned int c = 0; c < dim; ++c)
              forces[nodes[i] * dim + c] += specific * share[i] * uniform[c];
        else
          for (std::size_t q = 0; q < values.n_points(); ++q)
            for (unsigned int c = 0; c < dim; ++c)
              {
                const double force =
                  specific * values.volume(q) * direction.value(values.point(q), c);
                for (std::size_t i = 0; i < n_local; ++i)
                  forces[nodes[i] * dim + c] += force * values.value(i, q);
              }
      }
  }


  template <int dim>
  void
  LoadAssembly<dim>::add_temperature(const LoadDefinition &load,
                                     const double t,
                                     Vector &forces) const
  {
    TemperatureField<dim> temperature;
    temperature.add(model, mesh.body_names, load, t, 1.);
    Vector modulus(mesh.body_names.size(), 0.);
    for (const Material &material : model.materials)
      modulus[index_of(mesh.body_names, material.body)] =
        thermal_modulus(material, model.assumption);

    const std::size_t n_local = discretization.reference_element().n_nodes();
    CellValues<dim> values(discretization);
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        const unsigned int *nodes = discretization.cell_nodes(cell);
        const unsigned int body   = discretization.cell_body(cell);
        values.move_to(cell);
        for (std::size_t q = 0; q < values.n_points(); ++q)
          {
            const double stress =
              modulus[body] * temperature.strain(values.point(q), body) * values.volume(q);
            for (std::size_t i = 0; i < n_local; ++i)
              {
                for (unsigned int c = 0; c < dim; ++c)
                  forces[nodes[i] * dim + c] += stress * values.gradient(i, q)[c];
                if (discretization.is_axisymmetric())
                  forces[nodes[i] * dim] += stress * values.value(i, q) / values.point(q)[0];
              }
          }
      }
  }


  template <int dim>
  void
  LoadAssembly<dim>::add_surface_load(const LoadDefinition &load,
                                      const FieldExpression<dim> &intensity,
                                      Vector &forces) const
  {
    for (const auto &face :
         discretization.boundary_faces(selection(mesh.label_names, load.targets)))
      {
        const auto &table = discretization.reference_element().face(face.number);
        const FaceMap<dim> map(discretization, face);
        for (std::size_t q = 0; q < table.weight.size(); ++q)
          {
            const dealii::Point<dim> point = map.point(table.points[q]);
            const double area              = table.weight[q] * map.density(table.points[q]);
            dealii::Tensor<1, dim> traction;
            if (load.kind == LoadKind::pressure)
              traction = -intensity.value(point, 0) * map.normal(table.points[q]);
            else
              for (unsigned int c = 0; c < dim; ++c)
                traction[c] = intensity.value(point, c);
            for (std::size_t k = 0; k < table.nodes.size(); ++k)
              for (unsigned int c = 0; c < dim; ++c)
                forces[discretization.face_node(face, k) * dim + c] +=
                  area * table.values[q][k] * traction[c];
          }
      }
  }


  template <int dim>
  void
  LoadAssembly<dim>::add_point_force(const LoadDefinition &load,
                                     const FieldExpression<dim> &force,
                                     Vector &forces) const
  {
    std::vector<unsigned int> nodes;
    for (const auto &target : load.targets)
      for (const unsigned int node : nodes_of_target(discretization, mesh, target))
        nodes.push_back(node);
    if (load.targets.empty())
      nodes.push_back(node_at(load));
    for (const unsigned int node : nodes)
      for (unsigned int c = 0; c < dim; ++c)
        forces[node * dim + c] += force.value(discretization.position(node), c);
  }


  template <int dim>
  unsigned int
  LoadAssembly<dim>::node_at(const LoadDefinition &load) const
  {
    dealii::Point<dim> point, low, high;
    for (unsigned int c = 0; c < dim; ++c)
      point[c] = load.coordinates[c];
    low = high              = discretization.position(0);
    double nearest_distance = std::numeric_limits<double>::max();
    unsigned int nearest = 0, count = 0;
    for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
      {
        const auto &at        = discretization.position(node);
        const double distance = at.distance(point);
        for (unsigned int c = 0; c < dim; ++c)
          {
            low[c]  = std::min(low[c], at[c]);
            high[c] = std::max(high[c], at[c]);
          }
        if (distance < nearest_distance)
          {
            nearest          = node;
            nearest_distance = distance;
          }
      }
    const double tolerance = 1e-8 * low.distance(high);
    for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
      count += discretization.position(node).distance(point) <= tolerance ? 1 : 0;
    if (count == 0)
      throw InputError(fmt::format("{}: there is no node at {}; the nearest one is at {}. Put a "
                                   "point of the geometry there.",
                                   load_title(load),
                                   text_of(point),
                                   text_of(discretization.position(nearest), 9)));
    if (count > 1)
      throw InputError(fmt::format("{}: at {} the lips of a joint have {} nodes. Apply the force a "
                                   "little beside the joint, or use a traction.",
                                   load_title(load),
                                   text_of(point),
                                   count));
    return nearest;
  }


  template <int dim>
  void
  LoadAssembly<dim>::set_displacement(const LoadDefinition &load,
                                      const FieldExpression<dim> &displacement,
                                      Vector &prescribed) const
  {
    for (const auto &target : load.targets)
      for (const unsigned int node : nodes_of_target(discretization, mesh, target))
        for (unsigned int c = 0; c < dim; ++c)
          if (!load.expressions[c].empty() && fixed[node * dim + c])
            prescribed[node * dim + c] = displacement.value(discretization.position(node), c);
  }


  template class LoadAssembly<2>;
  template class LoadAssembly<3>;
} // namespace fuga
