// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/scheme_row.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    using Demand = SchemeRow::Demand;

    /** Return the unknown and the equation p = 0 of bar number @p i. */
    SchemeRow
    free_row(const ContactElement &element, const std::size_t k, const std::size_t i)
    {
      SchemeRow row;
      row.element = k;
      row.bar     = element.bar(i);
      row.own[i] = row.column[i] = 1.;
      return row;
    }

    /** Return the row p_i = Σ C_ij (d_j + D_j p_j) with the elastic deformations of the layer; see
     * LayerTangent. */
    SchemeRow
    stuck_layer_row(const ContactElement &element,
                    const std::size_t k,
                    const std::size_t i,
                    const LayerTangent &C,
                    const LayeredSystem &system)
    {
      SchemeRow row = free_row(element, k, i);
      row.demand    = Demand::layer;
      for (std::size_t j = 0; j < element.n_bars(); ++j)
        {
          row.stiffness[j] = C(i, j);
          row.own[j] -= C(i, j) * system.compliance(element.bar(j));
        }
      return row;
    }

    /**
     * Return the normal row of a sliding element. While the element slides along e, T is given by N
     * and the elastic shear follows it. The layer then responds with N - (C_nt/C_tt) T = C g,
     * C = C_nn - C_nt²/C_tt, where g is measured from lips that rise by tan ψ per slip,
     * ṡ = ḋ_t + (D_t - 1/C_tt) Ṫ along e. For a rigid or linear layer the equation remains
     * g + ... = 0, with C standing for any stiffness.
     */
    SchemeRow
    sliding_normal_row(const ContactElement &element,
                       const std::size_t k,
                       const TangentVector &e,
                       const double rise,
                       const LayerTangent &tangent,
                       const LayeredSystem &system)
    {
      const bool shear_layer = has_nonlinear_shear(element);
      const double ratio     = element.coupling != nullptr ? tangent.mixed / tangent.shear : 0.;
      const double excess =
        shear_layer ? system.compliance(element.tangential_bar) - 1. / tangent.shear : 0.;
      SchemeRow row = free_row(element, k, 0);
      double C      = std::pow(system.scale(row.bar), 2);
      row.demand    = Demand::riding;
      row.own[0]    = 0.;
      if (has_nonlinear_closure(element))
        {
          C          = tangent.normal - ratio * tangent.mixed;
          row.demand = Demand::layer;
          row.own[0] = 1. - C * system.compliance(row.bar);
        }
      row.stiffness[0] = C;
      for (std::size_t a = 0; a < 2; ++a)
        {
          row.own[1 + a]       = -ratio * tangent.direction[a] + C * rise * excess * e[a];
          row.stiffness[1 + a] = -C * rise * e[a];
        }
      return row;
    }

    /** Return the row of slip. Along a single bar the unknown is its dislocation, whatever the sign
     * of the slip. */
    SchemeRow
    sliding_row(const ContactElement &element,
                const std::size_t k,
                const TangentVector &e,
                const double friction)
    {
      SchemeRow row = free_row(element, k, 1);
      row.demand    = Demand::sliding;
      if (element.has_second_tangential_bar())
        {
          row.own    = {{friction, e[0], e[1]}};
          row.column = {{0., e[0], e[1]}};
        }
      else
        row.own[0] = e[0] * friction;
      return row;
    }

    /**
     * Return the row (1/k_s - D + c) T·n = d·n across the slip, n ⟂ e, where k_s is the secant
     * stiffness of the layer (1/D of a linear one) and c = @p turning, because in a finite step the
     * slip has the direction of T. It is multiplied by k/(1 + k c), where k = k_s, or any stiffness
     * if the layer is linear.
     */
    SchemeRow
    across_row(const ContactElement &element,
               const std::size_t k,
               const TangentVector &e,
               const LayerTangent &tangent,
               const LayeredSystem &system,
               const double turning)
    {
      SchemeRow row          = free_row(element, k, 2);
      row.demand             = Demand::layer_across;
      const TangentVector n  = normal_to(e);
      const std::size_t bar  = element.second_tangential_bar;
      const bool curved      = has_nonlinear_shear(element);
      const double stiffness = curved ? tangent.across : std::pow(system.scale(bar), 2);
      const double elastic   = curved ? 1. - tangent.across * system.compliance(bar) : 0.;
      const double turn      = stiffness * turning;
      row.column             = {{0., n[0], n[1]}};
      for (std::size_t a = 0; a < 2; ++a)
        {
          row.stiffness[1 + a] = stiffness / (1. + turn) * n[a];
          row.own[1 + a]       = (elastic + turn) / (1. + turn) * n[a];
        }
      return row;
    }
  } // namespace

  void
  append_rows(const ContactElement &element,
              const std::size_t k,
              const ContactState state,
              const TangentVector &direction,
              const Strength &strength,
              const LayerTangent &tangent,
              const LayeredSystem &system,
              std::vector<SchemeRow> &rows,
              const std::optional<double> &turning)
  {
    if (state == ContactState::open)
      {
        for (std::size_t i = 0; i < element.n_bars(); ++i)
          rows.push_back(free_row(element, k, i));
        return;
      }
    const bool no_shear = element.has_second_tangential_bar() && !strength.resists_shear();
    if (is_slipping(state) && !no_shear)
      {
        const TangentVector e = slip_direction(element, state, direction);
        if (has_nonlinear_closure(element) || strength.dilatancy != 0.)
          rows.push_back(sliding_normal_row(element, k, e, strength.dilatancy, tangent, system));
        rows.push_back(sliding_row(element, k, e, strength.friction));
        if (element.has_second_tangential_bar() && (has_nonlinear_shear(element) || turning))
          rows.push_back(across_row(element, k, e, tangent, system, turning.value_or(0.)));
        return;
      }
    if (has_nonlinear_closure(element))
      rows.push_back(stuck_layer_row(element, k, 0, tangent, system));
    for (std::size_t i = 1; i < element.n_bars(); ++i)
      if (no_shear)
        rows.push_back(free_row(element, k, i));
      else if (has_nonlinear_shear(element))
        rows.push_back(stuck_layer_row(element, k, i, tangent, system));
  }

  double
  row_residual(const SchemeRow &row, const ContactElement &element, const JointState &at)
  {
    const std::size_t k = row.element;
    switch (row.demand)
      {
        case Demand::no_force:
          return at.forces[row.bar] - at.unreleased[row.bar];
        case Demand::sliding:
          {
            const StrengthLine strength = strength_line(element, at, k);
            const double sign           = slip_sign(at.states[k]);
            double value                = 0.;
            for (std::size_t i = element.n_bars(); i-- > 1;)
              value += row.own[i] * at.forces[element.bar(i)];
            return value + sign * strength.friction * at.forces[element.normal_bar] -
                   sign * strength.cohesion;
          }
        case Demand::layer:
          {
            const LayerForces law = layer_forces(element, at, k);
            return at.forces[row.bar] - (row.bar == element.normal_bar       ? law.normal
                                         : row.bar == element.tangential_bar ? law.shear[0]
                                                                             : law.shear[1]);
          }
        case Demand::layer_across:
          {
            const TangentVector T = tangential(element, at.forces);
            const TangentVector d = sum(tangential(element, at.dislocations), -1., at.slips[k]);
            double value          = 0.;
            for (std::size_t a = 0; a < 2; ++a)
              value += row.own[1 + a] * T[a] - row.stiffness[1 + a] * d[a];
            return value;
          }
        case Demand::riding:
          return -row.stiffness[0] *
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
          return slip_sign(state) * shear_strength_rate(element, std::abs(row.own[0]), drive);
        case Demand::layer:
        case Demand::layer_across:
        case Demand::riding:
          return 0.;
      }
    return 0.;
  }
} // namespace fuga
