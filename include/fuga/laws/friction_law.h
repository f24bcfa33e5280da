// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_friction_law_h
#define fuga_laws_friction_law_h

namespace fuga
{
  /**
   * Coulomb's law with cohesion: |T| ≤ f|N| + c A while the element is closed, T = 0 while it is
   * open.
   */
  struct FrictionLaw
  {
    /** f ≥ 0. */
    double coefficient = 0.;
    /** c ≥ 0 [MPa]. */
    double cohesion = 0.;

    /** No shear can ever be carried: the tangential bars need not exist. */
    bool
    is_frictionless() const
    {
      return coefficient == 0. && cohesion == 0.;
    }
  };
} // namespace fuga

#endif
