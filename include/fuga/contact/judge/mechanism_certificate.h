// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_mechanism_certificate_h
#define fuga_contact_judge_mechanism_certificate_h

#include <fuga/base/fields.h>
#include <fuga/contact/tangent_vector.h>

namespace fuga
{
  /**
   * How far a motion w of the joints is from proving that the load cannot grow: the bodies move
   * rigidly, as the states of all elements allow, and the growing load does more work on the motion
   * than friction dissipates. All entries are relative.
   */
  struct MechanismCertificate
  {
    /** S w = 0: no force changes. */
    double resistance = 0.;
    /** Jump that contradicts an element's state, beside the largest: a closed element that opens or
     * slips below its strength, an open one that closes, slip across its force. */
    double inadmissible = 0.;
    /** Power of all loads = power of the bar forces, that is dissipation. */
    double balance = 0.;
    /** Power of the load's growth, of the loss of strength and of what broken bonds let go, less
     * the growth of the dissipation, beside the sum of its terms. Positive: the motion is driven.
     * Where this power vanishes because the load does not drive the motion but unloads the lips
     * that slide, that on the motion which no change of forces resists.
     */
    double drive = 0.;

    /** The largest of the entries that should vanish. */
    double
    error() const;

    /** The motion proves a limit load: error() is at most 0.02 (where the load approaches its limit
     * asymptotically the path ends while the motion still meets a small resistance), and the load
     * drives it by more than rounding. */
    bool
    proves() const;

    /** Nothing resists the motion, and the load does not drive it: it proves nothing. */
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

  /** How the contact condition of an element lets it move while no force changes. */
  struct Freedom
  {
    enum class Kind
    {
      /** In any way: the lips are apart. */
      open,
      /** The lips may part and slide, but not close: the force is zero, or a bond is at its tensile
       * strength. */
      parting,
      /** The lips may slide along the force, rising by the dilatancy. */
      sliding,
      /** Not at all. */
      none
    };

    Kind kind;
    /** Rise per slip of sliding lips. */
    double dilatancy;
    /** Direction of the force on sliding lips; zero if there is none, and they slide anywhere. */
    TangentVector along;
    /** Strength that a normal force gives, of parting and sliding lips. */
    double friction;
    /** Parting lips keep a shear strength of their own. */
    bool holds_shear;
  };
} // namespace fuga

#endif
