// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_barrier_certificate_h
#define fuga_contact_judge_barrier_certificate_h

namespace fuga
{
  /**
   * Tells how far virtual jumps and forces of the joints are from proving that there is no
   * continuation: the bodies carry the forces, no answer of an element to the load works on them,
   * but the load does (doc/theory.md, section 8). All entries are relative.
   */
  struct BarrierCertificate
  {
    /** S x + Bᵀ p = 0: the virtual forces are those of the virtual motion. */
    double equilibrium = 0.;
    /** Largest jump or force on which an element's answer could work, each in the unit that its
     * stiffness gives, relative to the largest jump. */
    double inadmissible = 0.;
    /** Power of the growth of the load, and of the strength that a reduction takes away, relative
     * to the sum of the sizes of its terms. If it is positive, no answer has this power. */
    double drive = 0.;

    /** Return the larger one of the entries that should vanish. */
    double
    error() const;

    /** Return approximately how many times larger than those of elastic joints the rates would have
     * to be for their work on the errors to equal that of the load. */
    double
    margin() const;

    /** Return whether the margin is at least 1e6: a path whose rates grow beyond that ends as
     * well. */
    bool
    proves() const;
  };
} // namespace fuga

#endif
