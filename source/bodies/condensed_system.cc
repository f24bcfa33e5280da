// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors


#include <deal.II/lac/vector.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/boundary_conditions.h>
#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/elastic_bodies.h>
#include <fuga/bodies/iterative_solver.h>
#include <fuga/bodies/joint_corners.h>
#include <fuga/bodies/joint_water_model.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/rigid_pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  template <int dim>
  CondensedSystem<dim>::CondensedSystem(const JointedMesh &jointed,
                                        const ModelDefinition &model_definition,
                                        const std::vector<bool> &frictionless,
                                        const Condensation condensation,
                                        const unsigned int stage)
    : mesh(jointed), model(model_definition)
  {
    check_names(mesh, model);
    space = std::make_unique<Discretization<dim>>(mesh, model, stage);
    check_outer_faces(*space);
    timer.finish("mesh and degrees of freedom");
    find_coordinates(frictionless);
    timer.finish("joints and supports");
    list_joint_faces();
    if (condensation == Condensation::at_once)
      condense();
  }

  template <int dim>
  void
  CondensedSystem<dim>::condense()
  {
    const Vector lips = factorise();
    find_rigid_motions();
    if (!matrix_free_solver)
      remove_rounding(lips);
    timer.finish("rigid motions");
  }

  template <int dim>
  CondensedSystem<dim>::~CondensedSystem() = default;

  template <int dim>
  void
  CondensedSystem<dim>::find_coordinates(const std::vector<bool> &frictionless)
  {
    fixed    = find_fixed_dofs(*space, mesh, model);
    pieces   = std::make_unique<RigidPieces<dim>>(*space, mesh, fixed);
    geometry = std::make_unique<JointGeometry<dim>>(*space, mesh);
    bars     = std::make_unique<ContactBars<dim>>(*geometry, mesh, fixed, frictionless);
    if (std::find(frictionless.begin(), frictionless.end(), true) != frictionless.end() &&
        !pieces->are_held_by(*bars))
      {
        lines.push_back("the normal bars alone do not hold the structure: frictionless joints keep "
                        "their tangential bars");
        bars = std::make_unique<ContactBars<dim>>(
          *geometry, mesh, fixed, std::vector<bool>(mesh.joints.size(), false));
      }
    pieces->require_held_by(*bars);
    if (space->is_axisymmetric())
      lines.push_back("axisymmetric: areas and forces of the full circle; the axis is held in x");
    for (const auto &more : {corner_report(geometry->pairs(), mesh), bars->report()})
      lines.insert(lines.end(), more.begin(), more.end());
    bodies = std::make_unique<ElasticBodies<dim>>(*space, mesh, model);
    coordinates =
      std::make_unique<InterfaceCoordinates<dim>>(*space, *bars, fixed, bodies->node_moduli());
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::factorise()
  {
    SymmetricTriplets matrix = bodies->assemble(*coordinates);
    report_sizes(matrix);
    timer.finish("assembly");
    const Vector lips = lip_stiffness(matrix);
    choose_solver(matrix);
    if (matrix_free_solver)
      matrix_free_solver->prepare(matrix, coordinates->n_interface());
    else
      S = solver->eliminate(matrix, coordinates->n_interface());
    timer.finish("factorisation");
    return lips;
  }

  template <int dim>
  void
  CondensedSystem<dim>::report_sizes(const SymmetricTriplets &matrix)
  {
    lines.push_back(fmt::format("{} unknowns, {} of them interface coordinates; {} matrix entries",
                                coordinates->size(),
                                coordinates->n_interface(),
                                fmt::join(processes::from_all(matrix.values.size()), " + ")));
    if (processes::number() > 1)
      lines.push_back(fmt::format(
        "{} processes: {} cells, divided by {}",
        processes::number(),
        fmt::join(processes::from_all(space->n_own_cells()), " + "),
        space->is_divided_by_p4est() ? "p4est" : "METIS; every process keeps the whole mesh"));
  }

  // Diagonal of K in the interface coordinates: the stiffness of one lip if nothing else moves.
  template <int dim>
  Vector
  CondensedSystem<dim>::lip_stiffness(const SymmetricTriplets &matrix) const
  {
    const unsigned int first = coordinates->first_interface_coordinate();
    Vector result(coordinates->n_interface(), 0.);
    for (std::size_t k = 0; k < matrix.values.size(); ++k)
      if (matrix.rows[k] == matrix.columns[k] && matrix.rows[k] > static_cast<int>(first))
        result[static_cast<std::size_t>(matrix.rows[k] - 1) - first] += matrix.values[k];
    processes::sum(result);
    return result;
  }

  // A jump that the bodies follow without deformation meets no resistance; what elimination leaves
  // of the stiffness of its lip is rounding, and no later step could tell it from a soft body.
  template <int dim>
  void
  CondensedSystem<dim>::remove_rounding(const Vector &lips)
  {
    const double rounding = 64. * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < lips.size(); ++i)
      if (std::abs(S(i, i)) <= rounding * lips[i])
        for (std::size_t j = 0; j < lips.size(); ++j)
          S(i, j) = S(j, i) = 0.;
  }

  template <int dim>
  void
  CondensedSystem<dim>::find_rigid_motions()
  {
    motions = DenseMatrix(bars->bars().size(), pieces->n_free_motions());
    for (std::size_t k = 0; k < motions.n_columns(); ++k)
      {
        const Vector jump = bars->jumps(pieces->free_motion(k));
        std::copy(jump.begin(), jump.end(), motions.column(k));
      }
    motion_coordinates = motions;
    if (const DenseMatrix &B = jump_operator(); !B.empty() && motions.n_columns() > 0)
      {
        // Jumps of a motion of the bodies are compatible: B x = jumps has a solution.
        DenseMatrix gram   = multiply_transposed(B, B);
        motion_coordinates = multiply_transposed(B, motions);
        if (!solve_positive_definite(gram, motion_coordinates))
          throw NumericalFailure(
            "The jumps of the joints do not determine the motion of the bodies.");
      }
    projection = std::make_unique<RigidProjection>(motion_coordinates);
    if (!matrix_free_solver)
      projection->project_stiffness(S);
  }

  template <int dim>
  void
  CondensedSystem<dim>::list_joint_faces()
  {
    for (const auto &face : geometry->faces())
      {
        JointFace result;
        result.joint     = face.joint;
        result.area      = face.area;
        result.cell      = face.boundary.cell;
        result.number    = face.boundary.number;
        result.backwards = face.backwards;
        for (const unsigned int pair : face.pairs)
          {
            result.shares.push_back(bars->shares_of_pair(pair));
            result.positions.emplace_back();
            for (unsigned int c = 0; c < dim; ++c)
              result.positions.back()[c] = geometry->pairs()[pair].position[c];
          }
        faces.push_back(std::move(result));
      }
  }

  template <int dim>
  const DenseMatrix &
  CondensedSystem<dim>::jump_operator() const
  {
    return coordinates->jump_operator();
  }

  template <int dim>
  const std::vector<ContactElement> &
  CondensedSystem<dim>::elements() const
  {
    return bars->elements();
  }

  template <int dim>
  std::array<double, 3>
  CondensedSystem<dim>::normal(const std::size_t element) const
  {
    std::array<double, 3> result{};
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = bars->pair_of_element(element).normal[c];
    return result;
  }

  template <int dim>
  std::array<std::array<double, 3>, 2>
  CondensedSystem<dim>::tangents(const std::size_t element) const
  {
    std::array<std::array<double, 3>, 2> result{};
    for (unsigned int k = 0; k + 1 < dim; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        result[k][c] = bars->tangents_of_element(element)[k][c];
    return result;
  }

  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::by_degrees_of_freedom(const Vector &u) const
  {
    dealii::Vector<double> result(space->n_dofs_of_all_bodies());
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[space->dof(node, c)] = u[node * dim + c];
    return result;
  }

  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace fuga
