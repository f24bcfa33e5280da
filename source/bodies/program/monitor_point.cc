// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/fe/fe.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/base/errors.h>
#include <fuga/base/similar_names.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/program/monitor_point.h>
#include <fuga/bodies/space/cell_coordinates.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    constexpr unsigned int no_body = static_cast<unsigned int>(-1);

    std::string
    title(const MonitorDefinition &definition)
    {
      return fmt::format("{}: monitor '{}'", definition.origin, definition.name);
    }
  } // namespace


  template <int dim>
  MonitorPoint<dim>::MonitorPoint(const Discretization<dim> &space,
                                  const JointedMesh &mesh,
                                  const MonitorDefinition &definition)
    : discretization(space), point(find_position(mesh, definition))
  {
    const unsigned int body = index_of(mesh.body_names, definition.body);
    LoneCell<dim> alone(space);
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      {
        if (!definition.body.empty() && space.cell_body(cell) != body)
          continue;
        const auto inside = alone.coordinates(cell, point);
        if (!inside)
          continue;
        Shares found = shares_in(cell, *inside);
        // Neighbours share the nodes of their face; the lips of a joint do not.
        if (!shares.empty() &&
            !std::equal(found.begin(),
                        found.end(),
                        shares.begin(),
                        shares.end(),
                        [](const NodeShare &a, const NodeShare &b) { return a.node == b.node; }))
          throw InputError(
            fmt::format("{}: {} lies on a joint, where each lip moves on its own. {}",
                        title(definition),
                        text_of(point),
                        definition.body.empty()
                          ? "Say by 'Body' which lip is meant."
                          : "Both lips belong to this body: put the point a little beside "
                            "the joint."));
        if (shares.empty())
          its_body = space.cell_body(cell);
        shares = std::move(found);
        if (space.cell_body(cell) == its_body)
          add_gradients(cell, alone.gradients(*inside));
      }
    if (shares.empty() && !is_in_absent_body(definition.body.empty() ? no_body : body))
      fail_outside(definition);
  }


  template <int dim>
  bool
  MonitorPoint<dim>::is_in_absent_body(const unsigned int body) const
  {
    double n_cells_around = 0.;
    if (!discretization.is_complete())
      for (const auto &cell : discretization.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() &&
            discretization.cell_number(cell->active_cell_index()) == Discretization<dim>::no_cell &&
            (body == no_body || cell->material_id() == body) &&
            coordinates_in<dim>(cell, discretization.mapping(), point))
          n_cells_around += 1.;
    processes::sum(&n_cells_around, 1);
    return n_cells_around > 0.;
  }


  template <int dim>
  dealii::Point<dim>
  MonitorPoint<dim>::find_position(const JointedMesh &mesh,
                                   const MonitorDefinition &definition) const
  {
    dealii::Point<dim> result;
    std::array<double, 3> coordinates = definition.coordinates;
    if (!definition.point_name.empty())
      {
        const auto vertices = vertices_of_point(mesh, definition.point_name);
        std::vector<std::string> names;
        for (const auto &named : mesh.points)
          names.push_back(named.name);
        if (vertices.empty())
          throw InputError(
            fmt::format("{}: the mesh has no point '{}'. Points: {}.{}",
                        title(definition),
                        definition.point_name,
                        names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                        did_you_mean(definition.point_name, names, " ")));
        coordinates = mesh.vertices[vertices.front()];
        for (const unsigned int vertex : vertices)
          if (mesh.vertices[vertex] != coordinates)
            throw InputError(fmt::format("{}: there are {} points '{}'. Give coordinates.",
                                         title(definition),
                                         vertices.size(),
                                         definition.point_name));
      }
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = coordinates[c];
    return result;
  }


  template <int dim>
  typename MonitorPoint<dim>::Shares
  MonitorPoint<dim>::shares_in(const std::size_t cell,
                               const dealii::Point<dim> &in_reference_cell) const
  {
    const auto &element = discretization.reference_element().scalar_element();
    Shares result;
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      {
        const double share = element.shape_value(i, in_reference_cell);
        // On a face or at a corner the share of the other nodes is only rounding.
        if (std::abs(share) > 10. * inside_tolerance)
          result.push_back({discretization.cell_nodes(cell)[i], share});
      }
    replace_hanging_nodes(result);
    std::sort(result.begin(), result.end(), [](const NodeShare &a, const NodeShare &b) {
      return a.node < b.node;
    });
    return result;
  }


  template <int dim>
  void
  MonitorPoint<dim>::replace_hanging_nodes(Shares &of_nodes) const
  {
    const auto &masters = discretization.hanging_nodes().masters();
    if (masters.empty())
      return;
    std::map<unsigned int, double> sums;
    for (const NodeShare &one : of_nodes)
      if (const auto hanging = masters.find(one.node); hanging == masters.end())
        sums[one.node] += one.share;
      else
        for (const auto &[master, weight] : hanging->second)
          sums[master] += weight * one.share;
    of_nodes.clear();
    for (const auto &[node, share] : sums)
      if (std::abs(share) > 10. * inside_tolerance)
        of_nodes.push_back({node, share});
  }


  template <int dim>
  void
  MonitorPoint<dim>::add_gradients(const std::size_t cell,
                                   const std::vector<dealii::Tensor<1, dim>> &of_cell)
  {
    for (std::size_t i = 0; i < of_cell.size(); ++i)
      gradients[discretization.cell_nodes(cell)[i]] += of_cell[i];
    ++n_cells;
  }


  template <int dim>
  Vector
  MonitorPoint<dim>::gradient_force(const unsigned int component,
                                    const unsigned int direction) const
  {
    Vector force(discretization.n_dofs(), 0.);
    for (const auto &[node, sum] : gradients)
      force[node * dim + component] = sum[direction] / static_cast<double>(n_cells);
    return force;
  }


  template <int dim>
  Vector
  MonitorPoint<dim>::unit_force(const unsigned int component) const
  {
    Vector force(discretization.n_dofs(), 0.);
    for (const NodeShare &node : shares)
      force[node.node * dim + component] = node.share;
    return force;
  }


  template <int dim>
  void
  MonitorPoint<dim>::fail_outside(const MonitorDefinition &definition) const
  {
    unsigned int nearest = 0;
    for (unsigned int node = 1; node < discretization.n_nodes(); ++node)
      if (discretization.position(node).distance(point) <
          discretization.position(nearest).distance(point))
        nearest = node;
    throw InputError(fmt::format(
      "{}: {} lies outside of {}; the nearest node of the mesh is at {}. Move the point "
      "into the mesh.",
      title(definition),
      text_of(point),
      definition.body.empty() ? "all bodies" : "body '" + definition.body + "'",
      text_of(discretization.position(nearest), 9)));
  }


  template class MonitorPoint<2>;
  template class MonitorPoint<3>;
} // namespace fuga
