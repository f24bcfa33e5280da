// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/dynamics/free_column.h>

namespace fuga
{
  LineIntegrals::LineIntegrals(const Vector &points)
    : values(points.size(), points.size())
    , slopes_by_values(points.size(), points.size())
    , slopes(points.size(), points.size())
  {
    std::vector<dealii::Point<1>> nodes;
    for (const double point : points)
      nodes.emplace_back(point);
    const auto polynomials = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
    const dealii::QGauss<1> rule(static_cast<unsigned int>(points.size()));
    std::vector<std::vector<double>> at(points.size(), std::vector<double>(2));
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        for (std::size_t i = 0; i < points.size(); ++i)
          polynomials[i].value(rule.point(q)[0], at[i]);
        for (std::size_t i = 0; i < points.size(); ++i)
          for (std::size_t j = 0; j < points.size(); ++j)
            {
              values(i, j) += rule.weight(q) * at[i][0] * at[j][0];
              slopes_by_values(i, j) += rule.weight(q) * at[i][0] * at[j][1];
              slopes(i, j) += rule.weight(q) * at[i][1] * at[j][1];
            }
      }
  }


  FreeColumn::FreeColumn(const std::vector<Cell> &cells,
                         const Foot &its_foot,
                         const Damping &its_damping,
                         const double radius,
                         const unsigned int n_rungs)
    : foot(its_foot), damping(its_damping), spectral_radius(radius), factors(n_rungs)
  {
    const std::size_t n = 2 * (cells.back().first_node + cells.back().heights.size());
    mass.assign(n, 0.);
    stiffness = DenseMatrix(n, n);
    for (const Cell &cell : cells)
      add_cell(cell);
    for (std::size_t c = 0; c < 2; ++c)
      if (foot.held[c])
        {
          mass[c] = 0.;
          for (std::size_t i = 0; i < n; ++i)
            stiffness(i, c) = stiffness(c, i) = 0.;
          stiffness(c, c) = 1.;
        }
  }


  // Masses as in lumped_mass().
  void
  FreeColumn::add_cell(const Cell &cell)
  {
    const double length = cell.heights.back() - cell.heights.front();
    Vector points;
    for (const double height : cell.heights)
      points.push_back((height - cell.heights.front()) / length);
    const LineIntegrals integrals(points);
    double sum = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += integrals.values(i, i);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c)
        {
          const std::size_t row = 2 * (cell.first_node + i) + c;
          mass[row] += cell.density * length * integrals.values(i, i) / sum;
          for (std::size_t j = 0; j < points.size(); ++j)
            stiffness(row, 2 * (cell.first_node + j) + c) +=
              cell.moduli[c] / length * integrals.slopes(i, j);
        }
  }


  void
  FreeColumn::begin(const Drive &drive)
  {
    forces = forces_of(drive);
    now.emplace(
      mass, [this](const Vector &v) { return damping_times(v); }, spectral_radius);
    now->begin(Vector(mass.size(), 0.), forces);
    next.emplace(*now);
  }


  void
  FreeColumn::restore(const IntegrationMemory &memory, const Drive &drive)
  {
    begin(drive);
    now->restore(memory);
  }


  void
  FreeColumn::try_step(const unsigned int rung, const double h, const Drive &drive)
  {
    if (!factors[rung])
      factors[rung].emplace(stiffness_of_step(h));
    forces_at_end = forces_of(drive);
    Vector growth = forces_at_end;
    add_multiple(-1., forces, growth);
    Vector change = now->push(h, growth);
    for (std::size_t c = 0; c < 2; ++c)
      if (foot.held[c])
        change[c] = 0.;
    factors[rung]->solve(change);
    next.emplace(*now);
    MotionLedger unused;
    next->advance(h, change, forces, unused);
  }


  void
  FreeColumn::finish_step()
  {
    now.emplace(*next);
    forces      = forces_at_end;
    Vector rest = forces;
    add_multiple(-1., multiply(stiffness, now->displacement()), rest);
    now->correct(rest);
  }


  Vector
  FreeColumn::strained() const
  {
    Vector result = next->displacement();
    add_multiple(damping.of_stiffness, next->velocity(), result);
    return result;
  }


  Vector
  FreeColumn::forces_of(const Drive &drive) const
  {
    Vector result(mass.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = -mass[i] * drive.acceleration[i % 2];
    for (std::size_t c = 0; c < 2; ++c)
      result[c] += 2. * foot.dashpots[c] * drive.wave[c];
    return result;
  }


  Vector
  FreeColumn::damping_times(const Vector &v) const
  {
    Vector result = damping.of_stiffness > 0. ? multiply(stiffness, v) : Vector(v.size(), 0.);
    for (std::size_t i = 0; i < v.size(); ++i)
      result[i] = damping.of_stiffness * result[i] + damping.of_mass * mass[i] * v[i];
    for (std::size_t c = 0; c < 2; ++c)
      result[c] += foot.dashpots[c] * v[c];
    return result;
  }


  DenseMatrix
  FreeColumn::stiffness_of_step(const double h) const
  {
    DenseMatrix result  = stiffness;
    const double damped = now->damping_factor(h);
    for (std::size_t j = 0; j < mass.size(); ++j)
      {
        for (std::size_t i = 0; i < mass.size(); ++i)
          result(i, j) *= 1. + damped * damping.of_stiffness;
        result(j, j) += (now->mass_factor(h) + damped * damping.of_mass) * mass[j] +
                        (j < 2 ? damped * foot.dashpots[j] : 0.);
      }
    return result;
  }
} // namespace fuga
