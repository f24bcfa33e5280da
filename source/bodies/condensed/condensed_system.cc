// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/loads/imposed_gap.h>
#include <fuga/bodies/loads/joint_water_model.h>
#include <fuga/bodies/loads/uplift_assembly.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return one part of all patterns as columns of a matrix; an empty matrix if no pattern has
     * it. */
    DenseMatrix
    columns_of(const std::vector<LoadPattern> &patterns, const Vector LoadPattern::*part)
    {
      std::size_t n_rows = 0;
      for (const LoadPattern &pattern : patterns)
        n_rows = std::max(n_rows, (pattern.*part).size());
      if (n_rows == 0)
        return {};
      DenseMatrix matrix(n_rows, patterns.size());
      for (std::size_t j = 0; j < patterns.size(); ++j)
        matrix.col(j).head((patterns[j].*part).size()) = view(patterns[j].*part);
      return matrix;
    }
  } // namespace


  double
  LinearResponse::value(const Vector &x, const Vector &a) const
  {
    return dot(coordinates, x) + dot(patterns, a);
  }


  template <int dim>
  CondensedSystem<dim>::CondensedSystem(const JointedMesh &jointed,
                                        const ModelDefinition &model_definition,
                                        const std::vector<bool> &frictionless,
                                        const Condensation condensation,
                                        const unsigned int stage)
    : BodyModel<dim>(jointed, model_definition, frictionless, stage), condensed(*this)
  {
    if (condensation == Condensation::at_once && !this->is_released())
      condensed.factorise();
  }


  template <int dim>
  CondensedSystem<dim>::~CondensedSystem() = default;


  template <int dim>
  unsigned int
  CondensedSystem<dim>::n_coordinates() const
  {
    return this->interface_coordinates().n_interface();
  }


  template <int dim>
  const SparseOperator &
  CondensedSystem<dim>::jump_operator() const
  {
    return this->interface_coordinates().jump_operator();
  }


  template <int dim>
  const WaterInJoints *
  CondensedSystem<dim>::water_in_joints() const
  {
    return water.get();
  }


  template <int dim>
  void
  CondensedSystem<dim>::set_load_patterns(std::vector<LoadPattern> new_patterns)
  {
    this->phases().restart();
    if (!condensed.is_factorised() && !this->is_released())
      condensed.factorise();
    patterns = std::move(new_patterns);
    for (LoadPattern &pattern : patterns)
      if (!pattern.prescribed.empty())
        this->interface_coordinates().extend_prescribed(pattern.prescribed);
    motion_loads = DenseMatrix(this->rigid_pieces().n_free_motions(), patterns.size());
    for (Eigen::Index k = 0; k < motion_loads.rows(); ++k)
      {
        const Vector motion = this->rigid_pieces().free_motion(k);
        for (std::size_t j = 0; j < patterns.size(); ++j)
          motion_loads(k, j) = dot(motion, patterns[j].forces);
      }
    F               = this->is_released() ? DenseMatrix(n_coordinates(), patterns.size())
                                          : condensed.condense(patterns, motion_loads);
    water_of_closed = columns_of(patterns, &LoadPattern::closed_water);
    water.reset();
    if (JointWaterModel<dim>::is_needed(patterns))
      water = std::make_unique<JointWaterModel<dim>>(this->uplift_assemblies(),
                                                     patterns,
                                                     this->definition(),
                                                     this->discretization(),
                                                     this->contact_bars());
    E = imposed_jumps_of(patterns, this->contact_bars().bars().size());
    this->phases().finish("condensation of loads");
  }


  template <int dim>
  void
  CondensedSystem<dim>::set_carried_load(const std::size_t number, const Vector &jumps)
  {
    carried = to_vector(F.col(number));
    if (E.size() == 0)
      E = DenseMatrix(this->contact_bars().bars().size(), patterns.size());
    E.col(number) = view(jumps);
  }


  template <int dim>
  double
  CondensedSystem<dim>::stress_free_value(const Vector &force, const unsigned int stage) const
  {
    for (const StressFreeShape &shape : shapes)
      if (shape.stage == stage)
        {
          dealii::Vector<double> u(this->discretization().n_dofs_of_all_bodies());
          for (std::size_t i = 0; i < shape.dofs.size(); ++i)
            u[static_cast<unsigned int>(shape.dofs[i])] = shape.displacements[i];
          return dot(force, this->discretization().by_nodes(u));
        }
    return 0.;
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
  dealii::Vector<double>
  CondensedSystem<dim>::recover(const Vector &a, const Vector &x) const
  {
    this->phases().restart();
    const Vector prescribed = combination(a, &LoadPattern::prescribed);
    Vector loads            = combination(a, &LoadPattern::forces);
    loads.resize(this->discretization().n_dofs(), 0.);
    Vector y(this->interface_coordinates().size(), 0.);
    std::copy(x.begin(), x.end(), y.end() - static_cast<std::ptrdiff_t>(x.size()));
    Vector u = this->interface_coordinates().distribute(y.data(), prescribed);
    condensed.add_bonded_response(loads, u);
    ++n_recovered_fields;
    this->phases().finish("recovery of displacements");
    return this->by_degrees_of_freedom(u);
  }


  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::bonded_field(const Vector &forces, const Vector &x) const
  {
    return this->by_degrees_of_freedom(bonded_field_by_nodes(forces, x));
  }


  template <int dim>
  Vector
  CondensedSystem<dim>::bonded_field_by_nodes(const Vector &forces, const Vector &x) const
  {
    Vector y(this->interface_coordinates().size(), 0.), loads = forces;
    std::copy(x.begin(), x.end(), y.end() - static_cast<std::ptrdiff_t>(x.size()));
    loads.resize(this->discretization().n_dofs(), 0.);
    Vector u = this->interface_coordinates().distribute(y.data(), {});
    condensed.add_bonded_response(loads, u);
    return u;
  }


  // Let w be the bonded response to the force q, and g the prescribed displacements of a pattern.
  // Then Maxwell's theorem gives q·u = w·P + (q - K w)·g of the bonded structure; the interface
  // coordinates add the work of the condensed force on them.
  template <int dim>
  LinearResponse
  CondensedSystem<dim>::response(const Vector &force) const
  {
    this->phases().restart();
    Vector w(this->discretization().n_dofs(), 0.);
    condensed.add_bonded_response(force, w);
    const Vector Kw = this->elastic_bodies().forces(w);

    LinearResponse result;
    for (const LoadPattern &pattern : patterns)
      {
        result.patterns.push_back(dot(w, pattern.forces));
        if (pattern.prescribed.empty())
          continue;
        const Vector g = this->interface_coordinates().distribute(
          Vector(this->interface_coordinates().size(), 0.).data(), pattern.prescribed);
        result.patterns.back() += dot(force, g) - dot(Kw, g);
      }
    if (this->interface_coordinates().n_interface() > 0)
      {
        const Vector residual = this->out_of_balance(force, w);
        DenseMatrix column(residual.size(), 1), work(this->rigid_pieces().n_free_motions(), 1);
        std::copy(residual.begin(), residual.end(), column.data());
        for (Eigen::Index k = 0; k < work.rows(); ++k)
          work(k, 0) = dot(this->rigid_pieces().free_motion(k), force);
        const DenseMatrix forces = condensed.condense(column, work);
        result.coordinates.assign(forces.data(), forces.data() + forces.rows());
      }
    this->phases().finish("monitors");
    return result;
  }


  template <int dim>
  typename CondensedSystem<dim>::RigidPart
  CondensedSystem<dim>::rigid_part(const Vector &x) const
  {
    RigidPart result;
    result.remainder = x;
    if (rigid_coordinates().size() == 0)
      return result;
    const Vector amounts = condensed.motion_of(x);
    Vector u(this->discretization().n_dofs(), 0.);
    for (std::size_t k = 0; k < amounts.size(); ++k)
      {
        const Vector motion = this->rigid_pieces().free_motion(k);
        for (std::size_t i = 0; i < u.size(); ++i)
          u[i] += amounts[k] * motion[i];
        for (std::size_t i = 0; i < x.size(); ++i)
          result.remainder[i] -= amounts[k] * rigid_coordinates()(i, k);
      }
    result.motion = this->by_degrees_of_freedom(u);
    return result;
  }


  template <int dim>
  EquilibriumError
  CondensedSystem<dim>::equilibrium_error(const dealii::Vector<double> &u,
                                          const Vector &p,
                                          const Vector &a,
                                          const dealii::Vector<double> &motion) const
  {
    return this->equilibrium_error_under(combination(a, &LoadPattern::forces), u, p, motion);
  }


  template <int dim>
  double
  CondensedSystem<dim>::balance_lips(const Vector &p,
                                     const Vector &a,
                                     dealii::Vector<double> &u) const
  {
    Vector loads         = this->bar_forces(p);
    const Vector applied = combination(a, &LoadPattern::forces);
    for (std::size_t i = 0; i < loads.size(); ++i)
      loads[i] = (applied.empty() ? 0. : applied[i]) - loads[i];
    const Vector missing = this->out_of_balance(loads, this->discretization().by_nodes(u));
    const Vector x       = condensed.coordinates_under(
      Vector(missing.end() - static_cast<std::ptrdiff_t>(n_coordinates()), missing.end()));
    if (x.empty())
      return 0.;
    u += bonded_field({}, x);
    return max_abs(multiply(jump_operator(), x));
  }


  template <int dim>
  BodiesWork
  CondensedSystem<dim>::work() const
  {
    BodiesWork work         = condensed.work();
    work.n_recovered_fields = n_recovered_fields;
    return work;
  }


  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace fuga
