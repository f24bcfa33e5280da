// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_rigid_basis_h
#define fuga_contact_system_rigid_basis_h

#include <fuga/base/numerics/accurate.h>
#include <fuga/contact/contact_system.h>

#include <vector>

namespace fuga
{
  /**
   * The rigid motions of the bodies that no support holds, orthonormal in the interface coordinates
   * and in extended precision. A body on a soft joint moves far more than it deforms; S x is then
   * nothing but rounding unless the motion, which S does not feel, is removed from x before.
   */
  class RigidBasis
  {
  public:
    explicit RigidBasis(const ContactSystem &system);

    bool
    empty() const
    {
      return motions.empty();
    }

    /** Remove the rigid part from x. */
    void
    remove(Accurate &x) const;

    /** Give condensed forces f the resultants of the load patterns with the factors @p a. */
    void
    correct_resultants(const Accurate &a, Accurate &f) const;

    /** Return S x: the rigid part of x meets no resistance, and the resistance has no resultant. */
    Accurate
    resistance(const DenseMatrix &S, const Accurate &x) const;

  private:
    struct Motion
    {
      Accurate coordinates;
      /** Work of the load patterns on the motions. */
      Accurate loads;
    };

    std::vector<Motion> motions;
  };
} // namespace fuga

#endif
