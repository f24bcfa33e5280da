// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>
#include <fuga/base/numerics/accurate.h>
#include <fuga/base/work_counter.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/scheme/working_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /**
     * Defects of a solution, relative to the forces that drive it, that are accepted at once, and
     * after refinement.
     */
    constexpr double good_defect     = 1e-13;
    constexpr double accepted_defect = 1e-8;
    /** Defect that is accepted for a solution in double precision. */
    constexpr double accepted_double_defect = 1e-12;
    /** Like largest_motion, in units of the force that drives its own rows, or of what rounding may
     * leave there: a larger answer is that of a matrix made of rounding. Forces of other bars,
     * where the structure is statically determinate, have no stiffness to be measured by. */
    constexpr double largest_answer = 1e13, rounding_of_drive = 1e-14;
    /** Numbers of sweeps of refinement with the inverse of the matrix itself, and with that of a
     * nearby one, as long as each sweep halves the defect. */
    constexpr int max_sweeps       = 3;
    constexpr int max_stale_sweeps = 20;

    void
    subtract(const double amount, const ConstVectorView &column, Vector &forces)
    {
      work::now().dense_operations += forces.size();
      view(forces) -= amount * column;
    }

    void
    subtract(const long double amount, const ConstVectorView &column, Accurate &forces)
    {
      work::now().accurate_operations += forces.size();
      add_scaled(forces.size(), -amount, column.data(), forces.data());
    }
  } // namespace

  WorkingScheme::WorkingScheme(const std::vector<ContactElement> &contact_elements,
                               const LayeredSystem &layered_system)
    : elements(contact_elements)
    , system(layered_system)
    , element_of_bar(layered_system.n_bars(), 0)
    , position(layered_system.n_bars(), no_row)
    , ever_active(layered_system.n_bars(), false)
  {
    states.assign(elements.size(), ContactState::stick);
    directions.assign(elements.size(), TangentVector{{1., 0.}});
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
        element_of_bar[elements[k].bar(i)] = k;
    for (const ContactElement &element : elements)
      {
        strengths.push_back(virgin_strength(element.friction, element.area));
        nonlinear |= has_nonlinear_closure(element) || has_nonlinear_shear(element) ||
                     element.friction.envelope.is_curved();
      }
    if (nonlinear)
      for (const ContactElement &element : elements)
        tangents.push_back(initial_layer_tangent(element));
    slopes.assign(tangents.size(), 1.);
  }

  double
  WorkingScheme::forces_in(const SchemeRow &row, const double *forces) const
  {
    const ContactElement &element = elements[row.element];
    double value                  = 0.;
    for (std::size_t a = 0; a < element.n_bars(); ++a)
      value += row.own[a] * forces[element.bar(a)];
    return value;
  }

  void
  WorkingScheme::set_state(const std::size_t element,
                           const ContactState state,
                           const TangentVector &direction)
  {
    outdated |= states[element] != state;
    states[element] = state;
    if (!is_slipping(state) || !elements[element].has_second_tangential_bar())
      return;
    outdated |= directions[element] != direction;
    directions[element] = direction;
  }

  void
  WorkingScheme::let_turn(const Vector &compliances)
  {
    outdated |= turning != compliances;
    turning = compliances;
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
      {
        const bool initial = stiffness == LayerStiffness::initial;
        tangents[k] =
          initial ? initial_layer_tangent(elements[k]) : layer_tangent(elements[k], at, k);
        slopes[k] = initial ? 1. : strength_slope(elements[k], at, k);
      }
    outdated = true;
  }

  // The result contains the forces and row defects that belong to the given active dislocations;
  // the return value is the largest defect, in the units of LayeredSystem::scale().
  template <typename Number>
  double
  WorkingScheme::apply(const std::vector<Number> &active,
                       const Vector &force_offset,
                       const Vector &rhs,
                       JointRates &result,
                       Vector &defect) const
  {
    const DenseMatrix &W = system.stiffness();
    std::vector<Number> forces(force_offset.begin(), force_offset.end());
    std::vector<Number> dislocations(system.n_bars(), 0.);
    for (std::size_t j = 0; j < rows.size(); ++j)
      {
        const ContactElement &element = elements[rows[j].element];
        for (std::size_t a = 0; a < element.n_bars(); ++a)
          if (const double share = rows[j].column[a]; share != 0.)
            {
              subtract(active[j] * share, W.col(element.bar(a)), forces);
              dislocations[element.bar(a)] += active[j] * share;
            }
      }
    double worst = 0.;
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const SchemeRow &row = rows[i];
        Number value         = -rhs[i];
        for (std::size_t a = 0; a < elements[row.element].n_bars(); ++a)
          {
            const std::size_t bar = elements[row.element].bar(a);
            value += row.own[a] * forces[bar] - row.stiffness[a] * dislocations[bar];
          }
        defect[i] = static_cast<double>(value);
        worst     = std::max(worst, std::abs(defect[i]) / system.scale(row.bar));
      }
    result.forces.assign(forces.begin(), forces.end());
    result.dislocations.assign(dislocations.begin(), dislocations.end());
    return worst;
  }

  // The solution is refined with the available inverse. The return value is the largest remaining
  // defect.
  template <typename Number>
  double
  WorkingScheme::refine(const Vector &rhs,
                        const Vector &force_offset,
                        const double driving_force,
                        JointRates &result) const
  {
    std::vector<Number> active(rows.size(), 0.);
    Vector defect = unbalanced_forces(rhs, force_offset);
    double worst  = std::numeric_limits<double>::infinity();
    double last   = worst;
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
    return worst;
  }

  // A body that hardly anything holds moves far more than it deforms, and W d in double precision
  // does not have enough digits for the deformation; extended precision gives three more.
  std::optional<JointRates>
  WorkingScheme::solve(const Vector &rhs, Vector force_offset, const SchemeAnswer answer)
  {
    if (!bring_up_to_date())
      return {};
    if (last_solution && last_solution->rhs == rhs && last_solution->offset == force_offset)
      return last_solution->result;

    double driving_force = 0., driving_rows = 0.;
    for (std::size_t i = 0; i < force_offset.size(); ++i)
      driving_force = std::max(driving_force, std::abs(force_offset[i]) / system.scale(i));
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const double scale = system.scale(rows[i].bar);
        driving_force      = std::max(driving_force, std::abs(rhs[i]) / scale);
        driving_rows       = std::max(driving_rows,
                                std::abs(forces_in(rows[i], force_offset.data()) - rhs[i]) / scale);
      }
    const double largest =
      std::min(largest_motion * driving_force,
               largest_answer * std::max(driving_rows, rounding_of_drive * driving_force));

    JointRates result;
    const auto refined_solution = [&]() {
      if (refine<double>(rhs, force_offset, driving_force, result) >
            accepted_double_defect * driving_force &&
          (stale || (refine<long double>(rhs, force_offset, driving_force, result) >
                       accepted_defect * driving_force &&
                     defect_of_layers(rhs, result) > accepted_defect * driving_force)))
        return false;
      return answer == SchemeAnswer::of_any_size ||
             system.scaled_size(result.dislocations) <= largest;
    };
    if (!refined_solution() && ((singular = !rebuild()) || !refined_solution()))
      return {};
    if (answer == SchemeAnswer::of_no_mechanism)
      last_solution = {rhs, std::move(force_offset), result};
    return result;
  }

  // An active (nonlinear) bar feels the additional dislocation only as a force of its layer.
  std::optional<JointRates>
  WorkingScheme::rates(const Drive &drive, const Vector &imposed)
  {
    // The search for the rates of one event may solve thousands of schemes.
    interruption::check("while the next states of the joints were looked for");
    if (!bring_up_to_date())
      return {};
    const DenseMatrix &W = system.stiffness();
    Vector rhs = drives_of_rows(drive), offset = drive.reactions;
    for (std::size_t i = 0; i < rows.size() && !imposed.empty(); ++i)
      {
        const ContactElement &element = elements[rows[i].element];
        for (std::size_t a = 0; a < element.n_bars(); ++a)
          if (position[element.bar(a)] != no_row)
            rhs[i] -= rows[i].stiffness[a] * imposed[element.bar(a)];
      }
    for (std::size_t bar = 0; bar < imposed.size(); ++bar)
      if (position[bar] == no_row && imposed[bar] != 0.)
        view(offset) -= imposed[bar] * W.col(bar);
    std::optional<JointRates> result = solve(rhs, offset);
    if (result)
      for (std::size_t bar = 0; bar < imposed.size(); ++bar)
        if (position[bar] == no_row)
          result->dislocations[bar] += imposed[bar];
    return result;
  }

  // Where the drive works on no free motion, almost nothing of it is left unresisted. Rigid joints
  // that cross may resist less than the stiffness that is usually added; a smaller one then leaves
  // far less.
  std::optional<WorkingScheme::FreeMotion>
  WorkingScheme::driven_motion(const Drive &drive) const
  {
    constexpr double smallest = 1e-12;
    constexpr double undriven = 1e-12, far_less = 1e-4;
    const Vector rhs                         = drives_of_rows(drive);
    const std::optional<MotionBeside> motion = motion_beside(usual_addition, rhs, drive.reactions);
    if (!motion)
      return {};
    if (motion->unresisted <= undriven)
      return FreeMotion{motion->refined, false, true};
    const std::optional<MotionBeside> rest = motion_beside(smallest, rhs, drive.reactions);
    if (rest && rest->unresisted <= std::min(far_less * motion->unresisted, undriven))
      return FreeMotion{rest->refined, false, true};
    return FreeMotion{motion->first, true};
  }

  // Refinement removes the effect of the added stiffness.
  std::optional<WorkingScheme::MotionBeside>
  WorkingScheme::motion_beside(const double added_stiffness,
                               const Vector &rhs,
                               const Vector &force_offset) const
  {
    const std::size_t n  = rows.size();
    Vector defect        = unbalanced_forces(rhs, force_offset);
    double driving_force = 0.;
    for (std::size_t i = 0; i < force_offset.size(); ++i)
      driving_force = std::max(driving_force, std::abs(force_offset[i]) / system.scale(i));
    for (std::size_t i = 0; i < n; ++i)
      driving_force = std::max(driving_force, std::abs(rhs[i]) / system.scale(rows[i].bar));
    const LuFactors factors(matrix_with_addition(added_stiffness));
    if (!(factors.reciprocal_condition() > 0.))
      return {};
    std::vector<long double> active(n, 0.L);
    MotionBeside result;
    double last = std::numeric_limits<double>::infinity(), worst = last;
    for (int sweep = 0; sweep < max_stale_sweeps && (sweep < 2 || worst < 0.5 * last); ++sweep)
      {
        factors.solve(defect);
        for (std::size_t i = 0; i < n; ++i)
          active[i] += defect[i];
        last = worst;
        worst =
          apply(active, force_offset, rhs, sweep == 0 ? result.first : result.refined, defect);
      }
    result.unresisted = driving_force > 0. ? worst / driving_force : 0.;
    return result;
  }

  std::optional<JointRates>
  WorkingScheme::response(const std::size_t bar)
  {
    Vector imposed(system.n_bars(), 0.);
    imposed[bar] = 1.;
    Drive at_rest;
    at_rest.reactions.assign(system.n_bars(), 0.);
    return rates(at_rest, imposed);
  }

  std::optional<JointRates>
  WorkingScheme::correction(const Vector &defects, const SchemeAnswer answer)
  {
    Vector rhs(defects.size());
    std::transform(defects.begin(), defects.end(), rhs.begin(), [](const double r) { return -r; });
    const Vector no_drive(system.n_bars(), 0.);
    std::optional<JointRates> result = solve(rhs, no_drive, answer);
    if (result || answer == SchemeAnswer::of_no_mechanism)
      return result;
    constexpr double hardly_unresisted       = 1e-3;
    const std::optional<MotionBeside> motion = motion_beside(usual_addition, rhs, no_drive);
    if (motion && motion->unresisted <= hardly_unresisted)
      return motion->refined;
    return {};
  }
} // namespace fuga
