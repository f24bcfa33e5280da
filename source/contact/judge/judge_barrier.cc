// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/judge/judge.h>
#include <fuga/contact/tangent_vector.h>

#include <algorithm>
#include <cmath>

// The conditions that the judge imposes on a virtual motion that is claimed to show that there is
// no continuation.
namespace fuga
{
  namespace
  {
    /** Ratio below which the stiffness of a row is only rounding; such rows are measured by the
     * largest one. */
    constexpr double no_stiffness = 1e-12;
  } // namespace

  double
  BarrierCertificate::error() const
  {
    return std::max(equilibrium, inadmissible);
  }

  double
  BarrierCertificate::margin() const
  {
    constexpr double rounding = 1e-14;
    return drive / std::max(error(), rounding);
  }

  bool
  BarrierCertificate::proves() const
  {
    constexpr double more_than_rates_of_a_path = 1e6;
    return equilibrium >= 0. && inadmissible >= 0. && margin() >= more_than_rates_of_a_path;
  }

  // Bodies and layer act in series, and everything else is at rest.
  double
  Judge::own_stiffness(const std::size_t bar, const double compliance) const
  {
    const DenseMatrix &S = system->stiffness();
    double stiffness     = 0.;
    dual.for_each_in_row(bar, [&](const std::size_t i, const double x_i) {
      dual.for_each_in_row(
        bar, [&](const std::size_t j, const double x_j) { stiffness += x_i * S(i, j) * x_j; });
    });
    stiffness = std::max(stiffness, no_stiffness * largest_diagonal(S));
    return stiffness / (1. + compliance * stiffness);
  }

  // An element answers with rates v of its dislocation and q of its forces, and y·q - p·v must not
  // be positive, nor more than z ρ̇ where lips are at a strength.
  Judge::VirtualError
  Judge::virtual_error(const Freedom &freedom,
                       const Layer &y,
                       const double pull,
                       const TangentVector &shear) const
  {
    using Kind         = Freedom::Kind;
    const double slide = length(y.shear), along = dot(y.shear, freedom.along);
    const auto below = [](const double value) { return std::max(0., -value); };
    switch (freedom.kind)
      {
        case Kind::open:
          return {0., 0., std::abs(pull), length(shear)};
        case Kind::none:
          return {std::abs(y.normal), slide, 0., 0.};
        case Kind::parting:
          if (freedom.holds_shear)
            return {below(y.normal), slide, below(pull), length(shear)};
          return {below(y.normal - freedom.friction * slide), 0., below(pull), length(shear)};
        case Kind::sliding:
          break;
      }
    if (length(freedom.along) == 0.)
      return {std::abs(y.normal),
              freedom.friction > 0. ? slide : 0.,
              below(freedom.dilatancy * pull),
              length(shear)};
    return {std::abs(y.normal - freedom.friction * along),
            std::max(below(along), length(sum(y.shear, -along, freedom.along))),
            0.,
            below(dot(shear, freedom.along) + freedom.dilatancy * pull)};
  }

  BarrierCertificate
  Judge::judge_barrier(const JointState &state, const JointRates &barrier) const
  {
    BarrierCertificate result;
    if (barrier.forces.empty() || in_motion || !system->has_stiffness() || state.is_unsettled() ||
        system->water_in_joints() != nullptr)
      return result;
    const SparseOperator &B = system->jump_operator();
    const Vector x          = coordinates(jumps(barrier.dislocations, barrier.forces));
    const Vector &p         = barrier.forces;
    const Vector jump       = multiply(B, x);
    const Vector carried    = multiply_transposed(B, p);
    const Vector elastic    = resistance(x);
    const double least      = no_stiffness * max_abs(stiffness_row_norms);
    for (std::size_t i = 0; i < x.size(); ++i)
      result.equilibrium = std::max(result.equilibrium,
                                    share(std::abs(elastic[i] + carried[i]),
                                          std::max(least, stiffness_row_norms[i]) * max_abs(x)));

    const Vector growth = growth_of_factors(state);
    double power = 0., size = 0.;
    const auto add = [&](const double term) {
      power += term;
      size += std::abs(term);
    };
    const Vector load_rates = multiply(system->load_patterns(), growth);
    for (std::size_t i = 0; i < x.size(); ++i)
      add(load_rates[i] * x[i]);
    if (system->imposed_jumps().size() > 0)
      {
        const Vector imposed = multiply(system->imposed_jumps(), growth);
        for (std::size_t bar = 0; bar < imposed.size(); ++bar)
          add(-p[bar] * imposed[bar]);
      }

    const Vector delta = jumps(state.dislocations, state.forces);
    const PathPoint answer{state, barrier};
    double largest = 0., worst = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const std::size_t n           = element.normal_bar;
        const Freedom free            = freedom(k, state, delta);
        const Layer deformed          = layer_rates(k, answer);
        const Layer y                 = {jump[n] - deformed.normal,
                                         sum(shear_part(element, jump), -1., deformed.shear)};
        const double normal_unit =
          std::sqrt(own_stiffness(n, bar_compliance(*element.normal_law, element.area)));
        const double shear_unit =
          element.has_tangential_bar()
            ? std::sqrt(own_stiffness(element.tangential_bar,
                                      bar_compliance(*element.shear_law, element.area)))
            : normal_unit;
        if (free.kind != Freedom::Kind::open)
          largest =
            std::max({largest, normal_unit * std::abs(y.normal), shear_unit * length(y.shear)});
        const VirtualError error = virtual_error(free, y, p[n], shear_part(element, p));
        worst                    = std::max({worst,
                                             normal_unit * error.normal_jump,
                                             shear_unit * error.shear_jump,
                                             error.pull / normal_unit,
                                             error.shear / shear_unit});
        const double falls = element.friction.reduced ? -history->strength_share_rate(state.t) : 0.;
        if (free.kind == Freedom::Kind::sliding)
          add(falls * dot(shear_part(element, state.forces), y.shear));
        if (free.kind == Freedom::Kind::parting)
          add(falls * state.forces[n] * y.normal);
      }
    result.inadmissible = share(worst, largest);
    result.drive        = share(power, size);
    return result;
  }
} // namespace fuga
