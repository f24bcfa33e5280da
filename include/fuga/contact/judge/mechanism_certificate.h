// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_mechanism_certificate_h
#define fuga_contact_judge_mechanism_certificate_h

#include <fuga/base/fields.h>
#include <fuga/contact/tangent_vector.h>

namespace fuga
{
  /**
   * Tells how far a motion w of the joints is from proving that the load cannot grow: the bodies
   * move rigidly, as the states of all elements allow, and the growing load does more work on the
   * motion than friction dissipates. All entries are relative.
   */
  struct MechanismCertificate
  {
    /** S w = 0: no force changes. */
    double resistance = 0.;
    /** Jump that contradicts an element's state, relative to the largest jump: a closed element
     * that opens or slips below its strength, an open one that closes, slip across the force. */
    double inadmissible = 0.;
    /** Power of all loads = power of the bar forces, i.e. dissipation. */
    double balance = 0.;
    /** Power of the growth of the load, of the loss of strength and of the forces that broken bonds
     * release, minus the growth of the dissipation, relative to the sum of its terms. If it is
     * positive, the motion is driven. Where this power vanishes because the load does not drive the
     * motion but unloads the sliding lips, it is the power on that motion which no change of forces
     * resists. */
    double drive = 0.;

    /** Return the largest of the entries that should vanish. */
    double
    error() const;

    /** Return whether the motion proves a limit load: error() is at most 0.02 (where the load
     * approaches its limit asymptotically the path ends while the motion still meets a small
     * resistance), and the load drives the motion by more than rounding. */
    bool
    proves() const;

    /** Return whether nothing resists the motion but the load does not drive it either, so that it
     * proves nothing. */
    bool
    is_neutral() const;
  };

  template <typename Proof, typename Visitor, only_for<Proof, MechanismCertificate> = 0>
  void
  for_each_field(Proof &proof, Visitor &&visit)
  {
    auto &[resistance, inadmissible, balance, drive] = proof;
    visit("resistance", resistance);
    visit("inadmissible", inadmissible);
    visit("balance", balance);
    visit("drive", drive);
  }

  /** The freedom that the contact condition gives an element to move while no force changes. */
  struct Freedom
  {
    enum class Kind
    {
      /** The lips are apart and may move in any way. */
      open,
      /** The lips may part and slide, but not close: the force is zero, or a bond is at its tensile
       * strength. */
      parting,
      /** The lips may slide along the force, rising by the dilatancy. */
      sliding,
      /** The lips cannot move. */
      none
    };

    Kind kind;
    /** Rise of sliding lips per unit of slip. */
    double dilatancy;
    /** Direction of the force on sliding lips; zero if there is none, so that they may slide in any
     * direction. */
    TangentVector along;
    /** Strength that a unit of normal force gives, for parting and sliding lips. */
    double friction;
    /** True if parting lips keep a shear strength of their own. */
    bool holds_shear;
  };
} // namespace fuga

#endif
