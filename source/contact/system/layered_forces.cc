// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr int n_sweeps = 2;
    /** Change in the first sweep, in units of LayeredSystem::scale() and of the largest force, that
     * bounds the error of W: the next sweep would change only the square of it. */
    constexpr double last_change = 1e-8;

    /** Return the largest force in these units. */
    template <typename Number>
    double
    size_of(const std::vector<Number> &forces, const Vector &scales)
    {
      double size = 0.;
      for (std::size_t i = 0; i < forces.size(); ++i)
        size = std::max(size, static_cast<double>(std::abs(forces[i])) / scales[i]);
      return size;
    }
  } // namespace

  // A unit force in a bar of compliance D moves the lips by D; to a share of this motion the
  // bodies, of the stiffness S, respond with that share of S D.
  bool
  LayeredSystem::has_soft_joint(const double rounding) const
  {
    constexpr double lost = 1e4 * std::numeric_limits<double>::epsilon();
    return rounding * largest_diagonal(bodies.stiffness()) * max_abs(compliances) > lost;
  }

  // Where joints cross, dislocations that the bodies cannot follow press against the small
  // compliance there: forces are small differences of W d. So they are where a body has moved far,
  // as in a fall, and deforms little.
  bool
  LayeredSystem::refines_forces(const Vector &dislocations, const Vector &forces) const
  {
    const double small_difference = saddle_factors ? 1e-3 : 1e-5;
    return delicate || (rigid_motions &&
                        size_of(forces, scales) < small_difference * scaled_size(dislocations));
  }

  // The loads are F a; on rigid motions they are the resultants of the loads, free of the rounding
  // of the condensation.
  Accurate
  LayeredSystem::loads_on_bodies(const Accurate &factors) const
  {
    const DenseMatrix &F = bodies.load_patterns();
    Accurate loads(F.rows(), 0.L);
    add_product(1.L, F, factors, loads);
    rigid_motions->correct_resultants(factors, loads);
    return loads;
  }

  Vector
  LayeredSystem::response(const Vector &factors,
                          const Vector &dislocations,
                          const Vector &water) const
  {
    Vector p = multiply(R, factors);
    subtract_response(dislocations, p);
    add_water(water, p);
    return p;
  }

  namespace
  {
    Vector
    sum(Vector x, const double sign, const Vector &y)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += sign * y[i];
      return x;
    }
  } // namespace

  Vector
  LayeredSystem::forces(const Vector &factors,
                        const Vector &dislocations,
                        const Vector &water,
                        const KnownForces *const known) const
  {
    Vector p = response(factors, dislocations, water);
    if (!refines_forces(dislocations, p))
      return p;
    if (known != nullptr)
      return sum(response(sum(factors, -1., known->factors),
                          sum(dislocations, -1., known->dislocations),
                          sum(water, -1., known->water)),
                 1.,
                 known->forces);
    if (saddle_factors)
      refine_with_jump_operator(factors, dislocations, water, p);
    else
      refine_in_jumps(factors, dislocations, water, p);
    return p;
  }

  // The equation is S (d + D p - E a) + p - ω = F a, with (1 + S D)⁻¹ = 1 - W D for the correction.
  void
  LayeredSystem::refine_in_jumps(const Vector &factors,
                                 const Vector &dislocations,
                                 const Vector &water,
                                 Vector &forces) const
  {
    const Accurate a = accurate(factors);
    Accurate given = loads_on_bodies(a), fixed_jumps = accurate(dislocations);
    if (bodies.imposed_jumps().size() > 0)
      add_product(-1.L, bodies.imposed_jumps(), a, fixed_jumps);
    for (std::size_t i = 0; i < water.size(); ++i)
      given[i] += water[i];
    for (int sweep = 0; sweep < n_sweeps; ++sweep)
      {
        Accurate residual = given, jumps = fixed_jumps;
        for (std::size_t i = 0; i < n_bars(); ++i)
          {
            jumps[i] += static_cast<long double>(compliances[i]) * forces[i];
            residual[i] -= forces[i];
          }
        add_scaled(-1.L, rigid_motions->resistance(bodies.stiffness(), jumps), residual);
        Vector elastic_jumps(n_bars());
        for (std::size_t j = 0; j < n_bars(); ++j)
          elastic_jumps[j] = compliances[j] * static_cast<double>(residual[j]);
        const Vector taken = multiply_symmetric(W, elastic_jumps);
        const double size  = size_of(forces, scales);
        Vector change(n_bars());
        for (std::size_t j = 0; j < n_bars(); ++j)
          {
            change[j] = static_cast<double>(residual[j]) - taken[j];
            forces[j] += change[j];
          }
        if (size_of(change, scales) <= last_change * size)
          break;
      }
  }

  // The equations are S x + Bᵀ p = F a + Bᵀ ω,  B x - D p = d - E a.
  void
  LayeredSystem::refine_with_jump_operator(const Vector &factors,
                                           const Vector &dislocations,
                                           const Vector &water,
                                           Vector &forces) const
  {
    const SparseOperator &B = bodies.jump_operator();
    const std::size_t n_x = B.n_columns(), n_p = n_bars();
    const Accurate a = accurate(factors);
    Accurate upper = loads_on_bodies(a), lower = accurate(dislocations);
    if (bodies.imposed_jumps().size() > 0)
      add_product(-1.L, bodies.imposed_jumps(), a, lower);
    if (!water.empty())
      add_transposed_product(1.L, B, accurate(water), upper);

    Accurate x(n_x, 0.L), p = accurate(forces);
    for (int sweep = 0; sweep <= n_sweeps; ++sweep)
      {
        Accurate force_defect = upper, jump_defect = lower;
        add_scaled(-1.L, rigid_motions->resistance(bodies.stiffness(), x), force_defect);
        add_transposed_product(-1.L, B, p, force_defect);
        add_product(-1.L, B, x, jump_defect);
        Vector change(n_x + n_p);
        for (std::size_t i = 0; i < n_x; ++i)
          change[i] = static_cast<double>(force_defect[i] / saddle_scale);
        for (std::size_t i = 0; i < n_p; ++i)
          change[n_x + i] = static_cast<double>(jump_defect[i] + compliances[i] * p[i]);
        saddle_factors->solve(change);
        for (std::size_t i = 0; i < n_x; ++i)
          x[i] += change[i];
        Accurate of_forces(n_p);
        for (std::size_t i = 0; i < n_p; ++i)
          {
            of_forces[i] = static_cast<long double>(change[n_x + i]) * saddle_scale;
            p[i] += of_forces[i];
          }
        // The first sweep begins with forces, but without the displacements that belong to them.
        if (sweep > 0 && size_of(of_forces, scales) <= last_change * size_of(p, scales))
          break;
      }
    forces.assign(p.begin(), p.end());
  }

  // The columns of W and R are forces as well, those of unit dislocations and of unit loads. In a
  // matrix that contains S as it is, a rigid motion meets the rounding of S; beside a soft joint
  // this presses and drives bodies that nothing else presses.
  void
  LayeredSystem::refine_responses()
  {
    const Vector no_loads(R.cols(), 0.), no_dislocations(n_bars(), 0.);
    const auto refine = [this](const Vector &loads, const Vector &dislocations, double *column) {
      Vector forces(column, column + n_bars());
      refine_with_jump_operator(loads, dislocations, {}, forces);
      std::copy(forces.begin(), forces.end(), column);
    };
    for (Eigen::Index j = 0; j < R.cols(); ++j)
      {
        Vector unit = no_loads;
        unit[j]     = 1.;
        refine(unit, no_dislocations, R.col(j).data());
      }
    for (std::size_t j = 0; j < n_bars(); ++j)
      {
        Vector unit = no_dislocations;
        unit[j]     = -1.;
        refine(no_loads, unit, W.col(j).data());
      }
  }
} // namespace fuga
