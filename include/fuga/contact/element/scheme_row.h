// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_scheme_row_h
#define fuga_contact_element_scheme_row_h

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/system/layered_system.h>

#include <optional>

namespace fuga
{
  /** One number for each bar of an element: normal, first tangent, second tangent. */
  using BarWeights = std::array<double, 3>;

  /**
   * One unknown of a working scheme, an amount of dislocation x along `column`, and the equation
   * that the state of the element demands of it,
   *
   *     own · p - stiffness · d = right-hand side,     d = Σ x column,
   *
   * linearised, where p and d are those of the bars of the element (doc/theory.md, section 3).
   */
  struct SchemeRow
  {
    enum class Demand
    {
      /** p = the force that a broken bond still carries, else 0. */
      no_force,
      /** e·T + f N = cohesive strength, in the direction e of slip; in the plane T + σ f N = σ
       * (cohesive strength), where σ is its sign. */
      sliding,
      /** The force is that of the nonlinear layer. */
      layer,
      /** Across the slip, the force is that of the nonlinear layer. */
      layer_across,
      /** The gap is 0 above lips that rise as they slide, with a rigid or linear layer. */
      riding
    };

    Demand demand       = Demand::no_force;
    std::size_t element = 0;
    /** The bar by which the row is identified: no two rows of a scheme have the same one. */
    std::size_t bar = 0;
    BarWeights own = {{0., 0., 0.}}, stiffness = {{0., 0., 0.}};
    BarWeights column = {{0., 0., 0.}};

    bool
    operator==(const SchemeRow &row) const
    {
      return demand == row.demand && bar == row.bar && own == row.own &&
             stiffness == row.stiffness && column == row.column;
    }
  };

  /** Return the direction in which an element slips in a state, in space @p direction; zero if it
   * does not slip. */
  inline TangentVector
  slip_direction(const ContactElement &element,
                 const ContactState state,
                 const TangentVector &direction)
  {
    return element.has_second_tangential_bar() && is_slipping(state)
             ? direction
             : TangentVector{{slip_sign(state), 0.}};
  }

  /**
   * Append the rows of element @p k in the given state, in space with the given direction of slip.
   * @p tangent is that of a nonlinear layer. An element that has no strength left, with two
   * tangential bars, carries no shear in any state, so that its slip needs no direction. In a
   * finite step, @p turning is the slip of the step over the shear force [m/MN], by which a force
   * across the slip turns it; along a path, where slips of the past do not turn, it is zero.
   */
  void
  append_rows(const ContactElement &element,
              const std::size_t k,
              const ContactState state,
              const TangentVector &direction,
              const Strength &strength,
              const LayerTangent &tangent,
              const LayeredSystem &system,
              std::vector<SchemeRow> &rows,
              const std::optional<double> &turning = {});

  /** Return the left minus the right side of the equation that belongs to a row, not linearised
   * [MN]. */
  double
  row_residual(const SchemeRow &row, const ContactElement &element, const JointState &at);

  /** Return the rate of the right side of a row under a drive, in @p state [MN per unit of the
   * path]. */
  double
  row_drive(const SchemeRow &row,
            const ContactElement &element,
            const ContactState state,
            const Drive &drive);
} // namespace fuga

#endif
