// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/cubic.h>
#include <fuga/contact/certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    void
    raise(double &entry, const double value, const double scale)
    {
      entry = std::max(entry, share(std::max(value, 0.), scale));
    }

    /** Deformation of a bar's layer under a stress, from the law itself. */
    double
    deformation(const ComplianceLaw &law, const double stress)
    {
      if (law.kind() == ComplianceKind::rigid)
        return 0.;
      return std::copysign(law.deformation(std::abs(stress)), stress);
    }

    /** A layer under tension (a bond) keeps its first stiffness. */
    double
    closure(const ComplianceLaw &law, const double pressure)
    {
      return pressure < 0. ? law.initial_compliance() * pressure : deformation(law, pressure);
    }

    double
    energy_of(const ComplianceLaw &law, const double stress, const bool tension)
    {
      if (law.kind() == ComplianceKind::rigid)
        return 0.;
      if (tension)
        return 0.5 * law.initial_compliance() * stress * stress;
      return law.energy(law.deformation(std::abs(stress)));
    }
  } // namespace

  Judge::Layer
  Judge::layer(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    const double pressure         = -state.forces[element.normal_bar] / element.area;
    const double shear =
      element.has_tangential_bar() ? state.forces[element.tangential_bar] / element.area : 0.;
    if (element.coupling != nullptr)
      {
        const auto [w, e] = element.coupling->deformation(pressure, shear);
        return {-w, e};
      }
    return {-closure(*element.normal_law, pressure),
            element.has_tangential_bar() ? deformation(*element.shear_law, shear) : 0.};
  }

  double
  Judge::stored_energy(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    const double pressure         = -state.forces[element.normal_bar] / element.area;
    const double shear            = shear_force(k, state) / element.area;
    if (element.coupling != nullptr)
      {
        const auto [w, e] = element.coupling->deformation(pressure, shear);
        return element.area * element.coupling->energy(w, e);
      }
    double energy = energy_of(*element.normal_law, pressure, pressure < 0.);
    if (element.has_tangential_bar())
      energy += energy_of(*element.shear_law, shear, false);
    return element.area * energy;
  }

  // Rates of the elastic deformation, from the tangent of the law at the present stresses.
  Judge::Layer
  Judge::layer_rates(const std::size_t k, const PathPoint &point) const
  {
    const ContactElement &element = elements[k];
    const double A                = element.area;
    const double N_rate           = point.rates.forces[element.normal_bar] / A;
    const double T_rate =
      element.has_tangential_bar() ? point.rates.forces[element.tangential_bar] / A : 0.;
    const Layer now = layer(k, point.state);
    if (element.coupling != nullptr)
      {
        const ShearCoupling::Response r = element.coupling->response(-now.normal, now.shear);
        const double determinant        = r.dsigma_dw * r.dtau_de - r.dsigma_de * r.dsigma_de;
        return {(r.dtau_de * N_rate + r.dsigma_de * T_rate) / determinant,
                (r.dsigma_de * N_rate + r.dsigma_dw * T_rate) / determinant};
      }
    const auto rate = [](const ComplianceLaw &law, const double w, const double stress_rate) {
      const bool curved = law.kind() == ComplianceKind::nonlinear && w > 0.;
      return stress_rate * (curved ? 1. / law.tangent(w) : law.initial_compliance());
    };
    return {rate(*element.normal_law, -now.normal, N_rate),
            element.has_tangential_bar() ? rate(*element.shear_law, std::abs(now.shear), T_rate)
                                         : 0.};
  }

  // ∫T ds + ∫N do by Gauss's rule with three points, exact for cubics. o is the jump that no layer
  // accounts for: the rise of lips that slide, the opening of lips whose bond is being unloaded.
  void
  Judge::check_slip(const PathPoint &from, const PathPoint &to, const double length)
  {
    const double r           = std::sqrt(0.15);
    const double abscissae[] = {0.5 - r, 0.5, 0.5 + r};
    const double weights[]   = {5. / 18., 8. / 18., 5. / 18.};
    const auto work_of       = [&](const std::size_t bar,
                             const double value0,
                             const double rate0,
                             const double value1,
                             const double rate1) {
      const CubicOnUnitInterval force(from.state.forces[bar],
                                      from.rates.forces[bar] * length,
                                      to.state.forces[bar],
                                      to.rates.forces[bar] * length);
      const CubicOnUnitInterval jump(value0, rate0 * length, value1, rate1 * length);
      double work = 0.;
      for (int i = 0; i < 3; ++i)
        work += weights[i] * force.value(abscissae[i]) * jump.slope(abscissae[i]);
      return work;
    };

    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const ContactState state      = from.state.states[k];
        const std::size_t n           = element.normal_bar;
        const bool unloading          = state == ContactState::open &&
                               (from.state.unreleased[n] != 0. || to.state.unreleased[n] != 0.);
        const bool rising  = is_slipping(state) && from.state.strengths[k].dilatancy > 0.;
        const bool sliding = element.has_tangential_bar() && state != ContactState::stick;
        if (element.has_second_tangential_bar())
          check_slip_in_plane(k, from, to, length);
        if (element.has_second_tangential_bar() || (!unloading && !sliding))
          continue;

        const Layer layer0 = layer_rates(k, from), layer1 = layer_rates(k, to);
        double work = 0.;
        if (sliding)
          {
            const std::size_t t = element.tangential_bar;
            const double rho    = element.shear_law->initial_compliance() / element.area;
            const auto rate     = [&](const PathPoint &point, const Layer &layer) {
              return point.rates.dislocations[t] + rho * point.rates.forces[t] - layer.shear;
            };
            work += work_of(
              t, from.state.slips[k][0], rate(from, layer0), to.state.slips[k][0], rate(to, layer1));
            if (rising)
              {
                const double tangent = slip_sign(state) * from.state.strengths[k].dilatancy;
                work += work_of(n,
                                from.state.dilations[k],
                                tangent * rate(from, layer0),
                                to.state.dilations[k],
                                tangent * rate(to, layer1));
              }
          }
        if (unloading)
          {
            const double rho   = element.normal_law->initial_compliance() / element.area;
            const auto opening = [&](const PathPoint &point) {
              return point.state.dislocations[n] + rho * point.state.forces[n] -
                     layer(k, point.state).normal;
            };
            const auto rate = [&](const PathPoint &point, const Layer &layer) {
              return point.rates.dislocations[n] + rho * point.rates.forces[n] - layer.normal;
            };
            work += work_of(n, opening(from), rate(from, layer0), opening(to), rate(to, layer1));
          }
        check_rise(k, from.state, to.state);
        ledger.dissipation += work;
        element_dissipation[k] += work;
        largest_slip_work = std::max(largest_slip_work, std::abs(work));
        wrong_slip_work   = std::max(wrong_slip_work, -work);
      }
  }

  // The lips rise by tan ψ per slip as long as they may, and never sink.
  void
  Judge::check_rise(const std::size_t k, const JointState &from, const JointState &to)
  {
    const FrictionLaw &law = elements[k].friction;
    if (law.dilatancy == 0.)
      return;
    const double slip = is_slipping(from.states[k]) ? length(sum(to.slips[k], -1., from.slips[k])) : 0.;
    const double rise = from.strengths[k].dilatancy > 0. ? law.dilatancy * slip : 0.;
    wrong_rise        = std::max({wrong_rise,
                                  std::abs(to.dilations[k] - from.dilations[k] - rise),
                                  to.dilations[k] - law.dilation_limit});
  }

  void
  Judge::check_element(const std::size_t k,
                       const JointState &state,
                       const Vector &delta,
                       Certificate &result) const
  {
    const ContactElement &element = elements[k];
    const Strength &left          = state.strengths[k];
    const std::size_t n           = element.normal_bar;
    const double N                = state.forces[n];
    const double gap              = element.initial_gap + delta[n] - state.dilations[k];
    const double T                = shear_force(k, state);
    raise(result.tension, N - std::max(left.tension, state.unreleased[n]), largest_force);
    check_strength(k, left, result);
    if (state.states[k] == ContactState::open)
      {
        const double T_left =
          element.has_tangential_bar() ? state.unreleased[element.tangential_bar] : 0.;
        raise(result.penetration, -gap, largest_jump);
        raise(result.complementarity, std::abs(N - state.unreleased[n]), largest_force);
        raise(result.complementarity, std::abs(T - T_left), largest_force);
        return;
      }
    const Layer elastic = layer(k, state);
    raise(result.layer_law, std::abs(gap - elastic.normal), largest_jump);
    if (!element.has_tangential_bar())
      return;
    const double strength = left.friction * (left.tension > 0. ? -N : std::max(-N, 0.)) +
                            left.cohesion + std::abs(state.unreleased[element.tangential_bar]);
    raise(result.cone, std::abs(T) - strength, largest_force);
    if (element.has_second_tangential_bar())
      {
        if (is_slipping(state.states[k]))
          raise(result.slip_direction, std::abs(T - strength), largest_force);
        return;
      }
    raise(result.layer_law,
          std::abs(delta[element.tangential_bar] - state.slips[k][0] - elastic.shear),
          largest_jump);
    if (is_slipping(state.states[k]))
      raise(
        result.slip_direction, std::abs(T - slip_sign(state.states[k]) * strength), largest_force);
  }

  // What is left of the strength is all or nothing of what the law says, or of the share of it that
  // a strength reduction leaves.
  void
  Judge::check_strength(const std::size_t k, const Strength &left, Certificate &result) const
  {
    const FrictionLaw &law = elements[k].friction;
    const double A         = elements[k].area;
    const double s         = left.share;
    if ((left.friction != s * law.coefficient && left.friction != s * residual_friction(law)) ||
        (left.cohesion != 0. && left.cohesion != s * (law.cohesion * A)) ||
        (left.tension != 0. && left.tension != s * (law.tensile_strength * A)) ||
        (left.dilatancy != 0. && left.dilatancy != law.dilatancy))
      result.cone = std::numeric_limits<double>::infinity();
  }

  // A strength reduction leaves all elements it concerns the same share, and the others all.
  void
  Judge::check_reduction(const JointState &state, Certificate &result) const
  {
    double share = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const double left = state.strengths[k].share;
        if (elements[k].friction.reduced && std::isnan(share))
          share = left;
        if (!(left > 0. && left <= 1. && left == (elements[k].friction.reduced ? share : 1.)))
          result.cone = std::numeric_limits<double>::infinity();
      }
  }
} // namespace fuga
