// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/accurate.h>
#include <fuga/base/numerics/not_a_number.h>
#include <fuga/base/work_counter.h>
#include <fuga/contact/judge/judge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the accuracy to which the jump d + D p of a bar is known compared with that of a
     * rigid one: the rounding of p, which is of the size of the stiffness of the bodies, counts D
     * times. */
    Vector
    jump_weights(const std::vector<ContactElement> &elements, const DenseMatrix &S)
    {
      constexpr double smallest = 1e-4;
      const double stiffness    = largest_diagonal(S);
      Vector weights;
      for (const ContactElement &element : elements)
        element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
          weights.resize(std::max<std::size_t>(weights.size(), bar + 1), 1.);
          weights[bar] =
            std::max(smallest, 1. / (1. + stiffness * bar_compliance(law, element.area)));
        });
      return weights;
    }
  } // namespace

  Judge::Judge(const ContactSystem &contact_system,
               const std::vector<ContactElement> &contact_elements,
               const LoadHistory &load_history,
               const double end_of_loading)
    : system(&contact_system)
    , elements(contact_elements)
    , history(&load_history)
    , rigid_motions(contact_system)
  {
    element_dissipation.assign(elements.size(), 0.);
    for (double t = 0.; t < end_of_loading;)
      {
        t                       = history->next_corner(t);
        largest_load_of_history = std::max(largest_load_of_history, max_abs(loads(t)));
      }
    take_stiffness();
  }

  Judge::Judge(const ContactSystem &contact_system,
               const std::vector<ContactElement> &contact_elements,
               const LoadHistory &load_history)
    : Judge(contact_system, contact_elements, load_history, load_history.end())
  {
  }

  void
  Judge::take_stiffness()
  {
    const DenseMatrix &S = system->stiffness();
    stiffness_row_norms.assign(system->load_patterns().rows(), 0.);
    for (Eigen::Index j = 0; j < S.cols(); ++j)
      stiffness_row_norms[j] = S.col(j).norm(); // S = Sᵀ
    // This is done once, because the weights need no precision.
    if (const SparseOperator &B = system->jump_operator(); !B.is_identity() && dual.is_identity())
      dual = dual_of(B, jump_weights(elements, S));
  }

  double
  share(const double value, const double scale)
  {
    return value == 0. ? 0. : value / scale;
  }

  TangentVector
  shear_part(const ContactElement &element, const Vector &of_bars)
  {
    return element.has_tangential_bar() ? tangential(element, of_bars) : TangentVector{{0., 0.}};
  }

  TangentVector
  direction(const TangentVector &v)
  {
    const double size = length(v);
    return {{share(v[0], size), share(v[1], size)}};
  }

  double
  Judge::largest_of_elements(const Vector &of_bars) const
  {
    double result = 0.;
    for (const ContactElement &element : elements)
      result = std::max(
        {result, std::abs(of_bars[element.normal_bar]), length(shear_part(element, of_bars))});
    return result;
  }

  Vector
  Judge::jumps(const Vector &dislocations, const Vector &forces) const
  {
    Vector result = dislocations;
    for (const ContactElement &element : elements)
      element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
        result[bar] += bar_compliance(law, element.area) * forces[bar];
      });
    return result;
  }

  // Weights of 1e-4 cost the inverse four digits, which one step with the defect δ - B x in
  // extended precision restores.
  Vector
  Judge::coordinates(const Vector &bar_jumps) const
  {
    if (dual.is_identity())
      return bar_jumps;
    Vector x        = multiply_transposed(dual, bar_jumps);
    Accurate defect = accurate(bar_jumps);
    add_product(-1.L, system->jump_operator(), accurate(x), defect);
    const Vector change = multiply_transposed(dual, Vector(defect.begin(), defect.end()));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += change[i];
    return x;
  }

  Vector
  Judge::coordinates(const Vector &bar_jumps, const double t) const
  {
    const DenseMatrix &E = system->imposed_jumps();
    if (E.size() == 0)
      return coordinates(bar_jumps);
    Vector of_bodies     = bar_jumps;
    const Vector imposed = multiply(E, history->factors(t));
    for (std::size_t i = 0; i < of_bodies.size(); ++i)
      of_bodies[i] -= imposed[i];
    return coordinates(of_bodies);
  }

  Vector
  Judge::loads(const double t) const
  {
    return multiply(system->load_patterns(), history->factors(t));
  }

  Vector
  Judge::water(const JointState &state) const
  {
    const WaterInJoints *joints = system->water_in_joints();
    if (joints == nullptr)
      return {};
    Vector result = joints->forces(state.access, history->factors(time(state)));
    for (std::size_t bar = 0; bar < result.size(); ++bar)
      result[bar] += state.kept_water[bar] - state.missing_water[bar];
    return result;
  }

  void
  Judge::add_water(const JointState &state, Vector &loads) const
  {
    const Vector omega = water(state);
    if (omega.empty())
      return;
    const Vector on_coordinates = multiply_transposed(system->jump_operator(), omega);
    for (std::size_t i = 0; i < loads.size(); ++i)
      loads[i] += on_coordinates[i];
  }

  // A body that a soft joint holds moves far more than it deforms: the part of x that is rigid
  // motion is removed, because its resistance is nothing but the rounding of S. Only this
  // difference needs extended precision. The product that follows does not: in double precision it
  // is wrong by at most n ε |S_i| |deformation|, and judge() concedes n ε |S_i| |x| to the rounding
  // of x anyway.
  Vector
  Judge::resistance(const Vector &x) const
  {
    if (!system->has_stiffness())
      return system->resistance(x);
    Accurate deformation = accurate(x);
    rigid_motions.remove(deformation);
    const Vector rounded(deformation.begin(), deformation.end());
    Accurate result = accurate(multiply_symmetric(system->stiffness(), rounded));
    rigid_motions.remove(result);
    return {result.begin(), result.end()};
  }

  // The error is that of forces and moments on every floating body, relative to what the largest
  // force would cause.
  double
  Judge::body_equilibrium_error(const JointState &state) const
  {
    const DenseMatrix &G = system->rigid_motions();
    if (G.size() == 0)
      return 0.;
    Vector carried     = multiply_transposed(G, state.forces);
    const Vector omega = water(state);
    if (!omega.empty())
      {
        const Vector pressed = multiply_transposed(G, omega);
        for (std::size_t i = 0; i < carried.size(); ++i)
          carried[i] -= pressed[i];
      }
    const Vector applied = multiply(system->rigid_motion_loads(), history->factors(time(state)));
    double worst         = 0.;
    for (std::size_t i = 0; i < applied.size(); ++i)
      {
        const double arm = largest_of_elements(to_vector(G.col(i)));
        worst = std::max(worst, share(std::abs(carried[i] - applied[i]), arm * largest_force));
      }
    return worst;
  }

  Certificate
  Judge::judge(const JointState &state)
  {
    const work::Scope phase(work::Phase::judge);
    const Vector delta = jumps(state.dislocations, state.forces);
    const Vector x     = coordinates(delta, time(state));
    Vector f           = loads(time(state));
    add_water(state, f);
    const Vector Sx = resistance(x);
    largest_force =
      std::max({largest_force, max_abs(f), largest_of_elements(state.forces), max_abs(Sx)});
    largest_jump = std::max(largest_jump, largest_of_elements(delta));

    Certificate result;
    const Vector p = multiply_transposed(system->jump_operator(), state.forces);
    // A body that soft joints hold moves far more than it deforms: S x, a sum of n terms in double
    // precision, is then uncertain by more than the forces allow, and only the part that exceeds
    // this uncertainty is an error. (The next entry, which does not know S, checks that such a body
    // is in equilibrium at all.) A body that has flown far has jumps with fewer digits than x, by
    // which a step changes them.
    const double n_terms  = std::max(4., static_cast<double>(x.size()));
    const double rounding = std::numeric_limits<double>::epsilon() *
                            (n_terms * std::sqrt(dot(x, x)) + largest_of_elements(delta));
    Vector elastic(f.size());
    for (std::size_t i = 0; i < f.size(); ++i)
      {
        elastic[i]         = f[i] - p[i];
        const double error = std::abs(Sx[i] - elastic[i]) - rounding * stiffness_row_norms[i];
        result.equilibrium =
          std::max(result.equilibrium, share(std::max(error, 0.), largest_force));
      }
    result.body_equilibrium = body_equilibrium_error(state);

    // ½ x·S x is computed from the elastic forces just checked, for the same reason.
    ledger.bodies = energy_of_bodies(x, elastic);
    ledger.layer  = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        check_element(k, state, delta, result);
        ledger.layer += stored_energy(k, state);
      }
    check_reduction(state, result);
    result.layer_law = std::max(result.layer_law, share(wrong_rise, largest_jump));
    if (on_track)
      {
        const double scale      = scale_of_energy(max_abs(f));
        const auto beyond_noise = [&](const double work) {
          return share(larger_error(work - rounding_of_work(), 0.), scale);
        };
        result.energy = beyond_noise(
          std::abs(ledger.external_work - ledger.bodies - ledger.layer - ledger.dissipation));
        result.slip_direction = std::max(result.slip_direction, beyond_noise(wrong_slip_work));
      }
    // Comparisons with something that is not a number tell nothing.
    if (!are_finite(state.forces) || !are_finite(delta) || !are_finite(state.dilations) ||
        !std::all_of(state.slips.begin(), state.slips.end(), are_finite<TangentVector>) ||
        !are_finite(f) || !are_finite(Sx))
      result.equilibrium = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
} // namespace fuga
