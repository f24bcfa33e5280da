// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_row_h
#define fuga_contact_scheme_row_h

#include <fuga/contact/layer_response.h>
#include <fuga/contact/layered_system.h>

namespace fuga
{
  /**
   * One equation of a working scheme: what the state of an element demands of one of its bars whose
   * dislocation is unknown,
   *
   *     own p[bar] + weight p[other] - stiffness d[bar] - cross d[other] = right-hand side,
   *
   * linearised (doc/theory.md, section 3). `other` is the second bar of the same element.
   */
  struct SchemeRow
  {
    enum class Demand
    {
      /** p = what a broken bond still carries, else 0. */
      no_force,
      /** T + σ f N = σ (cohesive strength). */
      sliding,
      /** The force is that of the nonlinear layer. */
      layer,
      /** Gap 0 above lips that rise as they slide, with a rigid or linear layer. */
      riding
    };

    Demand demand       = Demand::no_force;
    std::size_t element = 0;
    std::size_t bar     = 0;
    std::size_t other   = 0;
    double own = 1., weight = 0., stiffness = 0., cross = 0.;

    bool
    operator==(const SchemeRow &row) const
    {
      return demand == row.demand && bar == row.bar && own == row.own && weight == row.weight &&
             stiffness == row.stiffness && cross == row.cross;
    }
  };

  /** Appends the rows of element @p k in the given state. @p tangent is that of a nonlinear layer. */
  void
  append_rows(const ContactElement &element,
              const std::size_t k,
              const ContactState state,
              const Strength &strength,
              const LayerTangent &tangent,
              const LayeredSystem &system,
              std::vector<SchemeRow> &rows);

  /** Left minus right side of the equation behind a row, not linearised [MN]. */
  double
  row_residual(const SchemeRow &row, const ContactElement &element, const JointState &at);

  /** Rate of the right side of a row under a drive, in state @p state [MN per unit of the path]. */
  double
  row_drive(const SchemeRow &row,
            const ContactElement &element,
            const ContactState state,
            const Drive &drive);
} // namespace fuga

#endif
