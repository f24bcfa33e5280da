// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/elastic_bodies.h>
#include <fuga/bodies/imposed_gap.h>
#include <fuga/bodies/interior_solver.h>
#include <fuga/bodies/joint_water_model.h>
#include <fuga/bodies/level_history.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/rigid_pieces.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  template <int dim>
  LoadPattern
  CondensedSystem<dim>::assemble_load(const std::size_t number, const double t) const
  {
    timer.restart();
    const LoadDefinition &load = model.loads.at(number);
    LoadPattern pattern        = load.kind == LoadKind::uplift
                                   ? assemble_uplift(number, levels_of_water(load, model.constants, t))
                                   : LoadAssembly<dim>(*space, mesh, model, fixed).assemble(load, t);
    pattern.number_of_load     = number;
    if (load.kind == LoadKind::imposed_gap)
      pattern.jumps = imposed_gap<dim>(load, model.constants, t, mesh, *bars);
    timer.finish("loads");
    return pattern;
  }

  template <int dim>
  LoadPattern
  CondensedSystem<dim>::assemble_uplift(const std::size_t number, const WaterLevels &levels) const
  {
    return uplift(number).assemble(levels);
  }

  template <int dim>
  std::vector<double>
  CondensedSystem<dim>::levels_of_kinks(const std::size_t number) const
  {
    return uplift(number).levels_of_kinks();
  }

  template <int dim>
  const UpliftAssembly<dim> &
  CondensedSystem<dim>::uplift(const std::size_t number) const
  {
    uplifts.resize(model.loads.size());
    if (!uplifts[number])
      uplifts[number] =
        std::make_unique<UpliftAssembly<dim>>(model.loads[number], *space, *geometry, *bars, mesh);
    return *uplifts[number];
  }

  template <int dim>
  const WaterInJoints *
  CondensedSystem<dim>::water_in_joints() const
  {
    return water.get();
  }

  template <int dim>
  std::vector<std::string>
  CondensedSystem<dim>::ways_of_water() const
  {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (model.loads[i].kind == LoadKind::uplift)
        for (const std::string &line : uplift(i).way().report())
          result.push_back(line);
    return result;
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
  CondensedSystem<dim>::check_load_patterns(const std::vector<LoadPattern> &loads) const
  {
    for (const LoadPattern &pattern : loads)
      if (!pattern.prescribed.empty())
        check_settlement(pattern.prescribed);
  }

  template <int dim>
  void
  CondensedSystem<dim>::set_load_patterns(std::vector<LoadPattern> new_patterns)
  {
    check_load_patterns(new_patterns);
    timer.restart();
    if (!solver)
      condense();
    patterns = std::move(new_patterns);
    for (LoadPattern &pattern : patterns)
      if (!pattern.prescribed.empty())
        coordinates->extend_prescribed(pattern.prescribed);
    motion_loads = DenseMatrix(pieces->n_free_motions(), patterns.size());
    for (std::size_t k = 0; k < motion_loads.n_rows(); ++k)
      {
        const Vector motion = pieces->free_motion(k);
        for (std::size_t j = 0; j < patterns.size(); ++j)
          motion_loads(k, j) = dot(motion, patterns[j].forces);
      }
    DenseMatrix loads = loads_out_of_balance();
    F                 = solver->condense(loads);
    projection->project_loads(F, motion_loads);
    water_of_closed = columns_of(patterns, &LoadPattern::closed_water);
    water.reset();
    if (JointWaterModel<dim>::is_needed(patterns))
      water = std::make_unique<JointWaterModel<dim>>(uplifts, patterns, model, *space, *bars);
    E = imposed_jumps_of(patterns, bars->bars().size());
    timer.finish("condensation of loads");
  }

  // Condensing what the bonded structure leaves out of balance instead of the load itself keeps
  // rounding errors out of F that would grow with the model.
  template <int dim>
  DenseMatrix
  CondensedSystem<dim>::loads_out_of_balance() const
  {
    constexpr std::size_t at_once = 16; // one pass over the factors serves them all
    DenseMatrix result(coordinates->size(), patterns.size());
    if (coordinates->n_interface() == 0)
      return result; // recover() does all that is to be done
    for (std::size_t first = 0; first < patterns.size(); first += at_once)
      {
        const std::size_t n = std::min(at_once, patterns.size() - first);
        std::vector<Vector> u;
        DenseMatrix y(coordinates->size(), n);
        for (std::size_t j = 0; j < n; ++j)
          {
            const LoadPattern &pattern = patterns[first + j];
            u.push_back(coordinates->distribute(y.column(j), pattern.prescribed));
            const Vector load = out_of_balance(pattern.forces, u.back());
            std::copy(load.begin(), load.end(), y.column(j));
          }
        solver->solve(y);
        for (std::size_t j = 0; j < n; ++j)
          {
            u[j]                  = coordinates->distribute(y.column(j), u[j]);
            const Vector residual = out_of_balance(patterns[first + j].forces, u[j]);
            std::copy(residual.begin(), residual.end(), result.column(first + j));
          }
      }
    return result;
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
    const Vector load = out_of_balance(loads, u);
    DenseMatrix y(load.size(), 1);
    std::copy(load.begin(), load.end(), y.data());
    solver->solve(y);
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

  template LoadPattern
  CondensedSystem<2>::assemble_load(const std::size_t, const double) const;
  template LoadPattern
  CondensedSystem<2>::assemble_uplift(const std::size_t, const WaterLevels &) const;
  template std::vector<double>
  CondensedSystem<2>::levels_of_kinks(const std::size_t) const;
  template void
  CondensedSystem<2>::check_load_patterns(const std::vector<LoadPattern> &) const;
  template const WaterInJoints *
  CondensedSystem<2>::water_in_joints() const;
  template std::vector<std::string>
  CondensedSystem<2>::ways_of_water() const;
  template void CondensedSystem<2>::set_load_patterns(std::vector<LoadPattern>);
  template Vector
  CondensedSystem<2>::out_of_balance(const Vector &, const Vector &) const;
  template void
  CondensedSystem<2>::add_bonded_response(const Vector &, Vector &) const;
  template dealii::Vector<double>
  CondensedSystem<2>::recover(const Vector &, const Vector &) const;
  template LoadPattern
  CondensedSystem<3>::assemble_load(const std::size_t, const double) const;
  template LoadPattern
  CondensedSystem<3>::assemble_uplift(const std::size_t, const WaterLevels &) const;
  template std::vector<double>
  CondensedSystem<3>::levels_of_kinks(const std::size_t) const;
  template void
  CondensedSystem<3>::check_load_patterns(const std::vector<LoadPattern> &) const;
  template const WaterInJoints *
  CondensedSystem<3>::water_in_joints() const;
  template std::vector<std::string>
  CondensedSystem<3>::ways_of_water() const;
  template void CondensedSystem<3>::set_load_patterns(std::vector<LoadPattern>);
  template Vector
  CondensedSystem<3>::out_of_balance(const Vector &, const Vector &) const;
  template void
  CondensedSystem<3>::add_bonded_response(const Vector &, Vector &) const;
  template dealii::Vector<double>
  CondensedSystem<3>::recover(const Vector &, const Vector &) const;
} // namespace fuga
