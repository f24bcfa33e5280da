// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_barrier_certificate_h
#define fuga_contact_judge_barrier_certificate_h

namespace fuga
{
  /**
   * How far virtual jumps and forces of the joints are from proving that there is no continuation:
   * the bodies carry the forces, no answer of an element to the load works on them, the load does
   * (doc/theory.md, section 8). All entries are relative.
   */
  struct BarrierCertificate
  {
    /** S x + Bᵀ p = 0: the virtual forces are those of the virtual motion. */
    double equilibrium = 0.;
    /** Jump or force on which an element's answer could work, each in the unit that its stiffness
     * gives, beside the largest jump. */
    double inadmissible = 0.;
    /** Power of the load's growth, and of strength that a reduction takes, beside the sum of the
     * sizes of its terms. Positive: no answer has this power. */
    double drive = 0.;

    /** The larger one of the entries that should vanish. */
    double
    error() const;

    /** About how many times larger than those of elastic joints rates would have to be for their
     * work on the errors to be that of the load. */
    double
    margin() const;

    /** The margin is at least 1e6: a path whose rates grow beyond that ends as well. */
    bool
    proves() const;
  };
} // namespace fuga

#endif
