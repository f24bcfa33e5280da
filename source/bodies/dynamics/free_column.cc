// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/dynamics/free_column.h>

#include <numeric>

namespace fuga
{
  namespace
  {
    /** Return polynomials whose nodes are those of quadrilaterals and hexahedra. */
    std::vector<dealii::Polynomials::Polynomial<double>>
    polynomials_of(const unsigned int degree)
    {
      return dealii::Polynomials::generate_complete_Lagrange_basis(
        dealii::QGaussLobatto<1>(degree + 1).get_points());
    }
  } // namespace


  template <int dim>
  FreeColumn<dim>::FreeColumn(const std::vector<Cell> &cells_from_below,
                              const unsigned int degree_of_cells,
                              const Foot &its_foot,
                              const Damping &its_damping,
                              const double radius,
                              const unsigned int n_rungs)
    : cells(cells_from_below)
    , degree(degree_of_cells)
    , polynomials(polynomials_of(degree))
    , foot(its_foot)
    , damping(its_damping)
    , spectral_radius(radius)
    , mass(dim * (cells.size() * degree + 1), 0.)
    , stiffness(mass.size(), mass.size())
    , factors(n_rungs)
  {
    assemble();
    for (std::size_t c = 0; c < dim; ++c)
      if (foot.held[c])
        {
          mass[c] = 0.;
          for (std::size_t i = 0; i < mass.size(); ++i)
            stiffness(i, c) = stiffness(c, i) = 0.;
          stiffness(c, c) = 1.;
        }
  }


  // Masses are the same as in lumped_mass().
  template <int dim>
  void
  FreeColumn<dim>::assemble()
  {
    const dealii::QGauss<1> rule(degree + 1);
    for (std::size_t k = 0; k < cells.size(); ++k)
      {
        const Cell &cell    = cells[k];
        const double length = cell.top - cell.foot;
        Vector squares(degree + 1, 0.);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Place at = place(cell.foot + rule.point(q)[0] * length);
            for (std::size_t i = 0; i <= degree; ++i)
              {
                squares[i] += rule.weight(q) * at.values[i] * at.values[i];
                for (std::size_t j = 0; j <= degree; ++j)
                  for (std::size_t c = 0; c < dim; ++c)
                    stiffness(dim * (k * degree + i) + c, dim * (k * degree + j) + c) +=
                      (cell.mu + (c == dim - 1 ? cell.lambda + cell.mu : 0.)) * length *
                      rule.weight(q) * at.slopes[i] * at.slopes[j];
              }
          }
        const double sum = std::accumulate(squares.begin(), squares.end(), 0.);
        for (std::size_t i = 0; i <= degree; ++i)
          for (std::size_t c = 0; c < dim; ++c)
            mass[dim * (k * degree + i) + c] += cell.density * length * squares[i] / sum;
      }
  }


  template <int dim>
  auto
  FreeColumn<dim>::place(const double height) const -> Place
  {
    std::size_t k = 0;
    while (k + 1 < cells.size() && height > cells[k].top)
      ++k;
    const double length = cells[k].top - cells[k].foot;
    Place result;
    result.cell       = &cells[k];
    result.first_node = k * degree;
    std::vector<double> value_and_slope(2);
    for (const auto &polynomial : polynomials)
      {
        polynomial.value((height - cells[k].foot) / length, value_and_slope);
        result.values.push_back(value_and_slope[0]);
        result.slopes.push_back(value_and_slope[1] / length);
      }
    return result;
  }


  template <int dim>
  void
  FreeColumn<dim>::begin(const Drive &drive)
  {
    forces = forces_of(drive);
    now.emplace(
      mass, [this](const Vector &v) { return damping_times(v); }, spectral_radius);
    now->begin(Vector(mass.size(), 0.), forces);
    next.emplace(*now);
  }


  template <int dim>
  void
  FreeColumn<dim>::restore(const IntegrationMemory &memory, const Drive &drive)
  {
    begin(drive);
    now->restore(memory);
  }


  template <int dim>
  void
  FreeColumn<dim>::try_step(const unsigned int rung, const double h, const Drive &drive)
  {
    if (!factors[rung])
      factors[rung].emplace(stiffness_of_step(h));
    forces_at_end = forces_of(drive);
    Vector growth = forces_at_end;
    add_multiple(-1., forces, growth);
    const TimeIntegration::Change predicted = now->predicted(h);
    add_multiple(-1., multiply(stiffness, predicted.u), growth);
    add_multiple(-1., damping_times(predicted.v), growth);
    Vector change = now->push(growth);
    for (std::size_t c = 0; c < dim; ++c)
      if (foot.held[c])
        change[c] = 0.;
    factors[rung]->solve(change);
    next.emplace(*now);
    MotionLedger unused;
    next->advance(h, change, forces, unused);
  }


  template <int dim>
  void
  FreeColumn<dim>::finish_step()
  {
    now.emplace(*next);
    forces      = forces_at_end;
    Vector rest = forces;
    add_multiple(-1., multiply(stiffness, now->displacement()), rest);
    now->correct(rest);
  }


  template <int dim>
  Vector
  FreeColumn<dim>::strained() const
  {
    Vector result = next->displacement();
    add_multiple(damping.of_stiffness, next->velocity(), result);
    return result;
  }


  template <int dim>
  Vector
  FreeColumn<dim>::forces_of(const Drive &drive) const
  {
    Vector result(mass.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = -mass[i] * drive.acceleration[i % dim];
    for (std::size_t c = 0; c < dim; ++c)
      result[c] += 2. * foot.dashpots[c] * drive.wave[c];
    return result;
  }


  template <int dim>
  Vector
  FreeColumn<dim>::damping_times(const Vector &v) const
  {
    Vector result = damping.of_stiffness > 0. ? multiply(stiffness, v) : Vector(v.size(), 0.);
    for (std::size_t i = 0; i < v.size(); ++i)
      result[i] = damping.of_stiffness * result[i] + damping.of_mass * mass[i] * v[i];
    for (std::size_t c = 0; c < dim; ++c)
      result[c] += foot.dashpots[c] * v[c];
    return result;
  }


  template <int dim>
  DenseMatrix
  FreeColumn<dim>::stiffness_of_step(const double h) const
  {
    DenseMatrix result  = stiffness;
    const double damped = now->damping_factor(h);
    for (std::size_t j = 0; j < mass.size(); ++j)
      {
        for (std::size_t i = 0; i < mass.size(); ++i)
          result(i, j) *= 1. + damped * damping.of_stiffness;
        result(j, j) += (now->mass_factor(h) + damped * damping.of_mass) * mass[j] +
                        (j < dim ? damped * foot.dashpots[j] : 0.);
      }
    return result;
  }


  template class FreeColumn<2>;
  template class FreeColumn<3>;
} // namespace fuga
