// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/layer_work.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fuga
{
  namespace
  {
    /** Share of what a path may still lose by interpolation that one step may lose. */
    constexpr double share_of_step = 1e-2;
    /** Rounding error of a jump, relative to the largest one. */
    constexpr double jump_rounding = 16. * std::numeric_limits<double>::epsilon();

    /** A deformation of the layer and its rate. */
    struct LayerMotion
    {
      double value = 0.;
      double rate  = 0.;
    };

    LayerMotion
    closing(const PathContext &context, const std::size_t k, const PathPoint &point)
    {
      const ContactElement &element = context.elements[k];
      const std::size_t n           = element.normal_bar;
      const double rise             = point.state.strengths[k].dilatancy;
      double rate =
        point.rates.dislocations[n] + context.system.compliance(n) * point.rates.forces[n];
      if (rise > 0. && is_slipping(point.state.states[k]))
        rate -= rise * slip_speed(context, point, k);
      return {gap(element, point.state, k), rate};
    }

    // Return the motion along the tangent of bar number @p a.
    LayerMotion
    shearing(const PathContext &context,
             const std::size_t k,
             const std::size_t a,
             const PathPoint &point)
    {
      const ContactElement &element = context.elements[k];
      const std::size_t bar         = element.bar(a);
      double rate =
        point.rates.dislocations[bar] + context.system.compliance(bar) * point.rates.forces[bar];
      if (point.state.states[k] != ContactState::stick)
        rate -= slip_rate(element, point.state, k, point.rates)[a - 1];
      return {elastic_shear(element, point.state, k)[a - 1], rate};
    }

    /** Return the loads at the place @p tau of @p course, measured by the reactions of the closed
     * joints. */
    double
    size_of_loads(const PathContext &context, const Course &course, const double tau)
    {
      return max_abs(multiply(context.system.reactions(), course.factors_at(tau)));
    }

    /** Return the factor by which the loads of @p course can make the energies larger than the
     * largest loads up to @p tau have made them: the square of their growth. */
    double
    growth_of_energy(const PathContext &context,
                     const Course &course,
                     const double tau,
                     const IterationCount &count)
    {
      const double largest = std::max(count.largest_load, size_of_loads(context, course, tau));
      const double growth  = largest > 0. ? size_of_loads(context, course, course.length) / largest
                                          : std::numeric_limits<double>::infinity();
      return std::max(1., growth * growth);
    }

    /** Return the energy that a layer whose shear stiffness depends on its closure stores under
     * given forces. */
    template <typename ForceOfBar>
    double
    coupled_energy(const ContactElement &element, const ForceOfBar &force)
    {
      double shear = 0.;
      for (std::size_t a = 1; a < element.n_bars(); ++a)
        shear = std::hypot(shear, force(element.bar(a)));
      const auto [closure, jump] = element.coupling->deformation(
        std::abs(force(element.normal_bar)) / element.area, shear / element.area);
      return element.area * element.coupling->energy(closure, jump);
    }

    /** Return the energy that the layer of an element will store, predicted with the present rates
     * (@p of_rates, by bars) and bounded by what its law stores under the forces at the end. */
    template <typename ForceOfBar>
    double
    foreseen_energy(const ContactElement &element,
                    const Vector &of_rates,
                    const ForceOfBar &force_at_end)
    {
      double result = 0.;
      element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
        if (of_rates[bar] == 0. || element.coupling != nullptr)
          result += of_rates[bar];
        else
          {
            const double stress = std::abs(force_at_end(bar)) / element.area;
            result += std::min(of_rates[bar], element.area * law.energy(law.deformation(stress)));
          }
      });
      return result > 0. && element.coupling != nullptr
               ? std::min(result, coupled_energy(element, force_at_end))
               : result;
    }

    /** Return whether all @p forces of an element count as zero. */
    bool
    carries_nothing(const ContactBoundary &boundary,
                    const ContactElement &element,
                    const Vector &forces)
    {
      for (std::size_t i = 0; i < element.n_bars(); ++i)
        if (std::abs(forces[element.bar(i)]) > boundary.force_tolerance(element.bar(i)))
          return false;
      return true;
    }

    /** Return whether the lips are apart while a nonlinear layer is still sheared by what a broken
     * bond has left. */
    bool
    unloads_in_shear(const ContactElement &element, const JointState &at)
    {
      return element.coupling == nullptr && has_nonlinear_shear(element) &&
             length(tangential(element, at.unreleased)) > 0.;
    }
  } // namespace

  double
  slip_speed(const PathContext &context, const PathPoint &point, const std::size_t k)
  {
    const ContactElement &element = context.elements[k];
    const TangentVector rate      = slip_rate(element, point.state, k, point.rates);
    if (!element.has_second_tangential_bar())
      return slip_sign(point.state.states[k]) * rate[0];
    const TangentVector T = tangential(element, point.state.forces);
    return length(T) > 0. ? dot(T, rate) / length(T) : length(rate);
  }

  // The energy is what the judge will find missing in the balance of energy after this step: the
  // work of the interpolated force of every nonlinear bar compared with the energy that its layer
  // has stored. It measures how well the cubics between solved points represent the curve. It is
  // relative to the largest energy that the layers have stored or will have stored when the course
  // ends, since loads may fall to zero. The energy to come is predicted with the present rates; a
  // layer that is soft at first would promise too much of it, so that it is bounded by what its law
  // stores under the force at the end. Near a limit load, where rates grow without bound, it is
  // also bounded by the known energies and the growth of the loads. In a motion the energies of the
  // bodies are known as well. Jumps are known up to rounding errors of the largest one, and forces
  // that count as zero are nothing but such errors; no shorter step could fix their effect.
  StepEnergy
  energy_of_step(const PathContext &context,
                 const Course &course,
                 const ContactBoundary &here,
                 const PathPoint &from,
                 const PathPoint &to,
                 const double length,
                 const double tau,
                 IterationCount &count)
  {
    const double rest       = course.length - tau;
    const Vector jumps      = context.system.jumps(to.state.dislocations, to.state.forces);
    const double jump_noise = jump_rounding * max_abs(jumps);
    const auto force_at_end = [&](const std::size_t bar) {
      return to.state.forces[bar] + rest * to.rates.forces[bar];
    };
    double defect = 0., stored = 0., known = 0.;
    Vector of_rates(jumps.size(), 0.);
    for (std::size_t i = 0; i < jumps.size(); ++i)
      known += 0.5 * std::abs(to.state.forces[i] * jumps[i]);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        const bool open               = to.state.states[k] == ContactState::open;
        if (open ? !unloads_in_shear(element, from.state)
                 : !(has_nonlinear_closure(element) || has_nonlinear_shear(element)))
          continue;
        if (carries_nothing(here, element, from.state.forces) &&
            carries_nothing(here, element, to.state.forces))
          continue;
        double element_work = 0., noise = 0.;
        const auto work_of_bar =
          [&](const std::size_t bar, const LayerMotion &a, const LayerMotion &b) {
            const CubicOnUnitInterval force(from.state.forces[bar],
                                            from.rates.forces[bar] * length,
                                            to.state.forces[bar],
                                            to.rates.forces[bar] * length);
            element_work += work_of(force, {a.value, a.rate * length, b.value, b.rate * length});
            of_rates[bar] = 0.5 * std::abs(force_at_end(bar) * (b.value + rest * b.rate));
            noise += jump_noise * std::abs(to.state.forces[bar]);
          };
        if (has_nonlinear_closure(element) && !open)
          work_of_bar(element.normal_bar, closing(context, k, from), closing(context, k, to));
        for (std::size_t a = 1; a < element.n_bars() && has_nonlinear_shear(element); ++a)
          work_of_bar(element.bar(a), shearing(context, k, a, from), shearing(context, k, a, to));
        const double stored_before = nonlinear_energy(element, from.state, k);
        const double mismatch =
          std::abs(element_work - (nonlinear_energy(element, to.state, k) - stored_before));
        defect += std::max(mismatch - noise, 0.);
        stored += stored_before;
      }
    count.largest_energy = std::max(count.largest_energy, stored);
    const double before =
      std::max(count.largest_energy, context.system.contact_system().energy_scale());
    known       = std::max(known, before);
    double work = std::accumulate(of_rates.begin(), of_rates.end(), 0.);
    if (work > before) // the laws are more accurate, but expensive
      {
        work = 0.;
        for (const ContactElement &element : context.elements)
          work += foreseen_energy(element, of_rates, force_at_end);
      }
    if (work > known) // the growth is at least 1, and costs two products
      work = std::min(work, known * growth_of_energy(context, course, tau, count));
    return {defect, std::max(work, before)};
  }

  double
  energy_defect(const StepEnergy &energy, const double least_loss, const IterationCount &count)
  {
    const double left    = PathOptions::largest_energy_loss * energy.scale - count.energy_lost;
    const double allowed = std::max(least_loss * energy.scale, share_of_step * left);
    return energy.scale > 0. ? energy.lost / allowed : 0.;
  }

  void
  note_segment(const PathContext &context,
               const Course &course,
               PathSegment &segment,
               IterationCount &count)
  {
    count.energy_lost += segment.energy_lost();
    count.largest_load =
      std::max(count.largest_load, size_of_loads(context, course, segment.stations().back()));
  }
} // namespace fuga
