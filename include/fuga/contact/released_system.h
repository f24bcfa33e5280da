// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_released_system_h
#define fuga_contact_released_system_h

#include <fuga/contact/joint_state.h>
#include <fuga/contact/layered_system.h>

namespace fuga
{
  /**
   * A LayeredSystem some bars of which carry nothing: those of open elements, and the tangential
   * ones of elements without friction. Their dislocations d_o follow from p_o = 0,
   *
   *     d_o = W_oo⁻¹ (r_o - W_oc d_c),   p_c = r_c - W_co W_oo⁻¹ r_o - (W_cc - W_co W_oo⁻¹ W_oc)
   * d_c,
   *
   * with r the forces without any dislocation, and are no unknowns of the path
   * (doc/theory.md, section 17).
   */
  class ReleasedSystem
  {
  public:
    explicit ReleasedSystem(const LayeredSystem &system);

    /** Releases exactly these bars. Returns false if they leave a mechanism. */
    bool
    release(const std::vector<std::size_t> &bars);

    const std::vector<std::size_t> &
    released_bars() const
    {
      return bars;
    }

    /** W_cc - W_co W_oo⁻¹ W_oc for the given bars, none of them released [MN/m]. */
    DenseMatrix
    stiffness(const std::vector<std::size_t> &of_bars) const;

    /** The diagonal entry of W, before anything is released [MN/m]. */
    double
    own_stiffness(const std::size_t bar) const
    {
      return system.stiffness()(bar, bar);
    }

    /** r_c - W_co W_oo⁻¹ r_o for the given bars; @p reactions of all bars [MN]. */
    Vector
    reactions(const Vector &reactions, const std::vector<std::size_t> &of_bars) const;

    /** Overwrites the dislocations of the released bars by those that annul their forces; the
     * forces
     * without dislocations are @p reactions. */
    void
    complete(const Vector &reactions, Vector &dislocations) const;

    /** Motion of the released bars that nothing resists, if release() said that there is one. */
    JointRates
    mechanism() const;

  private:
    Vector
    solve(Vector forces) const;

    const LayeredSystem &system;
    std::vector<std::size_t> bars;
    /** Cholesky factor of W_oo with unit diagonal, and the roots of that diagonal. */
    DenseMatrix factor;
    Vector roots;
  };
} // namespace fuga

#endif
