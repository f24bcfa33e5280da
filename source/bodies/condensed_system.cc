// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/vector.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/boundary_conditions.h>
#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/elastic_bodies.h>
#include <fuga/bodies/imposed_gap.h>
#include <fuga/bodies/iterative_solver.h>
#include <fuga/bodies/level_history.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/rigid_pieces.h>
#include <fuga/bodies/uplift_assembly.h>

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
    lines.insert(lines.end(), bars->report().begin(), bars->report().end());
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
    Vector n_entries(processes::number(), 0.), n_cells = n_entries;
    n_entries[processes::rank()] = static_cast<double>(matrix.values.size());
    n_cells[processes::rank()]   = static_cast<double>(space->n_own_cells());
    processes::sum(n_entries);
    processes::sum(n_cells);
    lines.push_back(
      fmt::format("{} unknowns, {} of them interface coordinates; {:.0f} matrix entries",
                  coordinates->size(),
                  coordinates->n_interface(),
                  fmt::join(n_entries, " + ")));
    if (processes::number() > 1)
      lines.push_back(
        fmt::format("{} processes: {:.0f} cells", processes::number(), fmt::join(n_cells, " + ")));
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
    static_assert(JointFace::no_element == ContactBars<dim>::no_element, "same mark");
    for (const auto &face : geometry->faces())
      {
        JointFace result;
        result.joint = face.joint;
        result.area  = face.area;
        for (const unsigned int pair : face.pairs)
          {
            result.elements.push_back(bars->elements_of_pairs()[pair]);
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
  LoadPattern
  CondensedSystem<dim>::assemble_load(const std::size_t number, const double t) const
  {
    timer.restart();
    const LoadDefinition &load = model.loads.at(number);
    LoadPattern pattern        = load.kind == LoadKind::uplift
                                   ? UpliftAssembly<dim>(*space, *geometry, *bars, mesh)
                                .assemble(load, LevelHistory(load, model.constants)(t))
                                   : LoadAssembly<dim>(*space, mesh, model, fixed).assemble(load, t);
    if (load.kind == LoadKind::imposed_gap)
      pattern.jumps = imposed_gap<dim>(load, model.constants, t, mesh, *bars);
    timer.finish("loads");
    return pattern;
  }

  template <int dim>
  std::vector<double>
  CondensedSystem<dim>::levels_of_kinks(const std::size_t number) const
  {
    return UpliftAssembly<dim>(*space, *geometry, *bars, mesh)
      .levels_of_kinks(model.loads.at(number));
  }

  template <int dim>
  void
  CondensedSystem<dim>::check_settlement(const Vector &prescribed) const
  {
    double largest = 0.;
    for (const double value : prescribed)
      largest = std::max(largest, std::abs(value));
    for (const auto &pair : bars->held_pairs())
      {
        const bool obstacle = pair.minus_node == Discretization<dim>::no_node;
        const double jump   = prescribed[pair.plus_node * dim + pair.component] -
                            (obstacle ? 0. : prescribed[pair.minus_node * dim + pair.component]);
        if (std::abs(jump) > 1e-9 * largest)
          throw InputError(
            fmt::format("A settlement tears the two sides of a joint apart at {}, where supports "
                        "hold both of them in {}. Hold one side only, or move both alike.",
                        text_of(space->position(pair.plus_node)),
                        "xyz"[pair.component]));
      }
  }

  template <int dim>
  void
  CondensedSystem<dim>::set_load_patterns(std::vector<LoadPattern> new_patterns)
  {
    timer.restart();
    if (!solver)
      condense();
    patterns     = std::move(new_patterns);
    motion_loads = DenseMatrix(pieces->n_free_motions(), patterns.size());
    for (std::size_t k = 0; k < motion_loads.n_rows(); ++k)
      {
        const Vector motion = pieces->free_motion(k);
        for (std::size_t j = 0; j < patterns.size(); ++j)
          motion_loads(k, j) = dot(motion, patterns[j].forces);
      }
    DenseMatrix loads(coordinates->size(), patterns.size());
    for (std::size_t j = 0; j < patterns.size(); ++j)
      {
        Vector &prescribed = patterns[j].prescribed;
        if (!prescribed.empty())
          {
            check_settlement(prescribed);
            coordinates->extend_prescribed(prescribed);
          }
        if (coordinates->n_interface() == 0)
          continue; // recover() does all that is to be done
        // Condensing what the bonded structure leaves out of balance instead of the load itself
        // keeps rounding errors out of F that would grow with the model.
        Vector u = coordinates->distribute(Vector(coordinates->size(), 0.).data(), prescribed);
        add_bonded_response(patterns[j].forces, u);
        const Vector residual = out_of_balance(patterns[j].forces, u);
        std::copy(residual.begin(), residual.end(), loads.column(j));
      }
    F = solver->condense(loads);
    projection->project_loads(F, motion_loads);
    water_of_open   = columns_of(patterns, &LoadPattern::opening_water);
    water_of_closed = columns_of(patterns, &LoadPattern::closed_water);
    E               = imposed_jumps_of(patterns, bars->bars().size());
    timer.finish("condensation of loads");
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::combination(const Vector &a, const Vector LoadPattern::*part) const
  {
    Vector sum;
    for (std::size_t j = 0; j < patterns.size(); ++j)
      if (const Vector &column = patterns[j].*part; a[j] != 0. && !column.empty())
        {
          sum.resize(column.size(), 0.);
          for (std::size_t i = 0; i < column.size(); ++i)
            sum[i] += a[j] * column[i];
        }
    return sum;
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::out_of_balance(const Vector &loads, const Vector &u) const
  {
    Vector residual = bodies->forces(u);
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = loads[i] - residual[i];
    return coordinates->gather(residual);
  }

  template <int dim>
  void
  CondensedSystem<dim>::add_bonded_response(const Vector &loads, Vector &u) const
  {
    Vector y = out_of_balance(loads, u);
    solver->solve(y, Vector(coordinates->n_interface(), 0.));
    u = coordinates->distribute(y.data(), u);
  }

  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::recover(const Vector &a, const Vector &x) const
  {
    timer.restart();
    const Vector prescribed = combination(a, &LoadPattern::prescribed);
    Vector loads            = combination(a, &LoadPattern::forces);
    loads.resize(space->n_dofs(), 0.);
    Vector y(coordinates->size(), 0.);
    std::copy(x.begin(), x.end(), y.end() - static_cast<std::ptrdiff_t>(x.size()));
    Vector u = coordinates->distribute(y.data(), prescribed);
    add_bonded_response(loads, u);
    add_bonded_response(loads, u); // refines
    ++n_recovered_fields;
    timer.finish("recovery of displacements");
    return by_degrees_of_freedom(u);
  }

  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::by_degrees_of_freedom(const Vector &u) const
  {
    dealii::Vector<double> result(space->dof_handler().n_dofs());
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[space->dof(node, c)] = u[node * dim + c];
    return result;
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::by_nodes(const dealii::Vector<double> &u) const
  {
    Vector result(space->n_dofs());
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[node * dim + c] = u[space->dof(node, c)];
    return result;
  }

  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace fuga
