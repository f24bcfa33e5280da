// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/scheme_row.h>

namespace fuga
{
  namespace
  {
    using Demand = SchemeRow::Demand;

    /** N = C_nn g + C_nt e with g = d_n + D_n N, e = d_t + D_t T; the shear bar likewise. */
    SchemeRow
    stuck_layer_row(const SchemeRow &bars, const double C, const double C_mixed, const Vector &D)
    {
      SchemeRow row = bars;
      row.demand    = Demand::layer;
      row.own       = 1. - C * D[0];
      row.weight    = -C_mixed * D[1];
      row.stiffness = C;
      row.cross     = C_mixed;
      return row;
    }

    /**
     * While the element slides, T is given by N and the elastic shear follows it. The layer then
     * answers N - (C_nt/C_tt) T = C g, C = C_nn - C_nt²/C_tt, and g is reckoned from lips that rise
     * by σ tan ψ per slip, ṡ = ḋ_t + (D_t - 1/C_tt) Ṫ. A rigid or linear layer keeps g + ... = 0
     * with C standing for any stiffness.
     */
    SchemeRow
    sliding_normal_row(const SchemeRow &bars,
                       const ContactElement &element,
                       const double rise,
                       const LayerTangent &tangent,
                       const LayeredSystem &system)
    {
      const bool shear_layer = has_nonlinear_shear(element);
      const double ratio     = element.coupling != nullptr ? tangent.mixed / tangent.shear : 0.;
      const double D_n       = system.compliance(bars.bar);
      const double excess = shear_layer ? system.compliance(bars.other) - 1. / tangent.shear : 0.;
      SchemeRow row       = bars;
      double C            = system.stiffness()(bars.bar, bars.bar);
      row.demand          = Demand::riding;
      row.own             = 0.;
      if (has_nonlinear_closure(element))
        {
          C          = tangent.normal - ratio * tangent.mixed;
          row.demand = Demand::layer;
          row.own    = 1. - C * D_n;
        }
      row.weight    = -ratio + C * rise * excess;
      row.stiffness = C;
      row.cross     = -C * rise;
      return row;
    }
  } // namespace

  void
  append_rows(const ContactElement &element,
              const std::size_t k,
              const ContactState state,
              const Strength &strength,
              const LayerTangent &tangent,
              const LayeredSystem &system,
              std::vector<SchemeRow> &rows)
  {
    const std::size_t n  = element.normal_bar;
    const bool has_shear = element.has_tangential_bar();
    const std::size_t t  = has_shear ? element.tangential_bar : n;
    const SchemeRow normal{Demand::no_force, k, n, t, 1., 0., 0., 0.};
    const SchemeRow shear{Demand::no_force, k, t, n, 1., 0., 0., 0.};

    if (state == ContactState::open)
      {
        rows.push_back(normal);
        if (has_shear)
          rows.push_back(shear);
        return;
      }
    if (is_slipping(state))
      {
        const double rise = slip_sign(state) * strength.dilatancy;
        if (has_nonlinear_closure(element) || rise != 0.)
          rows.push_back(sliding_normal_row(normal, element, rise, tangent, system));
        rows.push_back(shear);
        rows.back().demand = Demand::sliding;
        rows.back().weight = slip_sign(state) * strength.friction;
        return;
      }
    const Vector D = {system.compliance(n), system.compliance(t)};
    if (has_nonlinear_closure(element))
      rows.push_back(stuck_layer_row(normal, tangent.normal, tangent.mixed, D));
    if (has_nonlinear_shear(element))
      rows.push_back(stuck_layer_row(shear, tangent.shear, tangent.mixed, {D[1], D[0]}));
  }

  double
  row_residual(const SchemeRow &row, const ContactElement &element, const JointState &at)
  {
    const std::size_t k   = row.element;
    const double p        = at.forces[row.bar];
    const bool is_tangent = row.bar != element.normal_bar;
    switch (row.demand)
      {
        case Demand::no_force:
          return p - at.unreleased[row.bar];
        case Demand::sliding:
          return p + row.weight * at.forces[row.other] -
                 slip_sign(at.states[k]) * cohesive_strength(element, at, k);
        case Demand::layer:
          {
            const LayerForces law = layer_forces(element, at, k);
            return p - (is_tangent ? law.shear : law.normal);
          }
        case Demand::riding:
          return -row.stiffness *
                 (at.dislocations[row.bar] + element.initial_gap - at.dilations[k]);
      }
    return 0.;
  }

  double
  row_drive(const SchemeRow &row,
            const ContactElement &element,
            const ContactState state,
            const Drive &drive)
  {
    switch (row.demand)
      {
        case Demand::no_force:
          return drive.release.empty() ? 0. : drive.release[row.bar];
        case Demand::sliding:
          return slip_sign(state) * shear_strength_rate(element, drive);
        case Demand::layer:
        case Demand::riding:
          return 0.;
      }
    return 0.;
  }
} // namespace fuga
