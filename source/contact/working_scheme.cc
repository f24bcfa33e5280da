// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/blas.h>
#include <fuga/contact/working_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /**
     * Defect of a solution, relative to the forces that drive it, that is accepted at once, and
     * after refinement. A mechanism answers with dislocations so large that their rounding errors
     * alone exceed the second: this, and no pivot, is what tells it from a soft scheme.
     */
    constexpr double good_defect     = 1e-13;
    constexpr double accepted_defect = 1e-8;
    /** The same for a solution refined with the inverse of a nearby matrix. */
    constexpr double accepted_stale_defect = 1e-12;
    /** Sweeps of refinement: with the inverse of the matrix itself, and with that of a nearby one,
     * as long as each divides the defect by two. */
    constexpr int max_sweeps       = 3;
    constexpr int max_stale_sweeps = 20;
  } // namespace

  WorkingScheme::WorkingScheme(const std::vector<ContactElement> &contact_elements,
                               const LayeredSystem &layered_system)
    : elements(contact_elements)
    , system(layered_system)
    , position(layered_system.n_bars(), no_row)
    , ever_active(layered_system.n_bars(), false)
  {
    states.assign(elements.size(), ContactState::stick);
    for (const ContactElement &element : elements)
      {
        strengths.push_back(virgin_strength(element.friction, element.area));
        nonlinear |= has_nonlinear_closure(element) || has_nonlinear_shear(element);
      }
    if (nonlinear)
      for (const ContactElement &element : elements)
        tangents.push_back(initial_layer_tangent(element));
  }

  void
  WorkingScheme::set_state(const std::size_t element, const ContactState state)
  {
    outdated |= states[element] != state;
    states[element] = state;
  }

  void
  WorkingScheme::set_strength(const std::size_t element, const Strength &strength)
  {
    outdated |= !(strengths[element] == strength);
    strengths[element] = strength;
  }

  void
  WorkingScheme::linearise(const JointState &at, const LayerStiffness stiffness)
  {
    if (!nonlinear)
      return;
    for (std::size_t k = 0; k < elements.size(); ++k)
      tangents[k] = stiffness == LayerStiffness::initial ? initial_layer_tangent(elements[k])
                                                         : layer_tangent(elements[k], at, k);
    outdated = true;
  }

  // Forces and row defects that belong to the given active dislocations; the largest defect.
  double
  WorkingScheme::apply(const Vector &active,
                       const Vector &force_offset,
                       const Vector &rhs,
                       JointRates &result,
                       Vector &defect) const
  {
    const DenseMatrix &W = system.stiffness();
    result.forces        = force_offset;
    result.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t j = 0; j < rows.size(); ++j)
      {
        blas::axpy(W.n_rows(), -active[j], W.column(rows[j].bar), result.forces.data());
        result.dislocations[rows[j].bar] = active[j];
      }
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const SchemeRow &row = rows[i];
        defect[i] = row.own * result.forces[row.bar] + row.weight * result.forces[row.other] -
                    row.stiffness * active[i] - row.cross * result.dislocations[row.other] - rhs[i];
      }
    return max_abs(defect);
  }

  std::optional<JointRates>
  WorkingScheme::solve(const Vector &rhs, Vector force_offset)
  {
    if (!bring_up_to_date())
      return {};

    const double driving_force  = std::max(max_abs(force_offset), max_abs(rhs));
    const auto refined_solution = [&](JointRates &result) {
      Vector active(rows.size(), 0.), defect(rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i)
        defect[i] = rows[i].own * force_offset[rows[i].bar] +
                    rows[i].weight * force_offset[rows[i].other] - rhs[i];
      double worst = std::numeric_limits<double>::infinity();
      double last  = worst;
      for (int sweep = 0; sweep == 0 || (worst > good_defect * driving_force &&
                                         (stale ? sweep < max_stale_sweeps && worst < 0.5 * last
                                                : sweep < max_sweeps));
           ++sweep)
        {
          last                = worst;
          const Vector change = inverse.solve(defect);
          for (std::size_t i = 0; i < active.size(); ++i)
            active[i] += change[i];
          worst = apply(active, force_offset, rhs, result, defect);
        }
      return worst <= (stale ? accepted_stale_defect : accepted_defect) * driving_force;
    };

    JointRates result;
    if (refined_solution(result))
      return result;
    singular = !rebuild();
    if (!singular && refined_solution(result))
      return result;
    return {};
  }

  std::optional<JointRates>
  WorkingScheme::rates(const Drive &drive)
  {
    if (!bring_up_to_date())
      return {};
    Vector rhs(rows.size(), 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
      rhs[i] = row_drive(rows[i], elements[rows[i].element], states[rows[i].element], drive);
    return solve(rhs, drive.reactions);
  }

  std::optional<JointRates>
  WorkingScheme::response(const std::size_t bar)
  {
    if (!bring_up_to_date())
      return {};
    // An active (nonlinear) bar feels the additional dislocation as force of its layer only.
    Vector rhs(rows.size(), 0.), offset(system.n_bars(), 0.);
    if (position[bar] != no_row)
      {
        for (std::size_t i = 0; i < rows.size(); ++i)
          if (rows[i].bar == bar)
            rhs[i] = -rows[i].stiffness;
          else if (rows[i].other == bar)
            rhs[i] = -rows[i].cross;
        return solve(rhs, offset);
      }
    for (std::size_t i = 0; i < offset.size(); ++i)
      offset[i] = -system.stiffness()(i, bar);
    std::optional<JointRates> result = solve(rhs, offset);
    if (result)
      result->dislocations[bar] = 1.;
    return result;
  }

  Vector
  WorkingScheme::residual(const JointState &at)
  {
    bring_up_to_date();
    Vector result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      result[i] = row_residual(rows[i], elements[rows[i].element], at);
    return result;
  }

  std::optional<JointRates>
  WorkingScheme::correction(const Vector &defects)
  {
    Vector rhs(defects.size());
    std::transform(defects.begin(), defects.end(), rhs.begin(), [](const double r) { return -r; });
    return solve(rhs, Vector(system.n_bars(), 0.));
  }

  // Inverse iteration on the matrix, shifted by rounding: three steps suffice for a
  // null vector that is only to be shown.
  JointRates
  WorkingScheme::mechanism() const
  {
    DenseMatrix M        = active_matrix();
    const double epsilon = 1e-14;
    for (std::size_t i = 0; i < rows.size(); ++i)
      M(i, i) += epsilon * std::max(system.stiffness()(rows[i].bar, rows[i].bar),
                                    epsilon * system.largest_stiffness());
    const LuFactors factors(std::move(M));
    Vector x(rows.size(), 1.);
    for (int step = 0; step < 3 && factors.reciprocal_condition() > 0.; ++step)
      {
        factors.solve(x);
        const double largest = max_abs(x);
        for (double &value : x)
          value /= largest;
      }
    JointRates result;
    result.forces.assign(system.n_bars(), 0.);
    result.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.dislocations[rows[i].bar] = x[i];
    return result;
  }
} // namespace fuga
