// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_certificate_h
#define fuga_contact_judge_certificate_h

#include <fuga/base/fields.h>

#include <array>
#include <string_view>
#include <utility>

namespace fuga
{
  /**
   * Tells how far a state is from satisfying each condition of the contact problem. Every entry is
   * relative to the largest force, jump or energy of the scene so far.
   */
  struct Certificate
  {
    /** S x + Bᵀp = F a. */
    double equilibrium = 0.;
    /** Balance of forces and moments on every floating body. */
    double body_equilibrium = 0.;
    /** gap ≥ 0 where there is no layer to close, or the element is open. */
    double penetration = 0.;
    /** N ≤ 0, or ≤ the tensile strength of a bond. */
    double tension = 0.;
    /** |T| ≤ f|N| + cA. */
    double cone = 0.;
    /** No force in open elements. */
    double complementarity = 0.;
    /** T·ṡ ≥ 0, slip only at the strength, and in 3D in the direction of T. */
    double slip_direction = 0.;
    /** N and T follow from closure and elastic shear by the laws of the layer, and the rise of the
     * lips from their slip. */
    double layer_law = 0.;
    /** External work = energy of the bodies + energy of the layer + dissipation. */
    double energy = 0.;

    double
    worst() const;

    /** Return the entries with their names, in the order above. */
    std::array<std::pair<std::string_view, double>, 9>
    entries() const;

    /** Keep the larger value of each entry. */
    void
    absorb(const Certificate &other);
  };

  template <typename Entries, typename Visitor, only_for<Entries, Certificate> = 0>
  void
  for_each_field(Entries &certificate, Visitor &&visit)
  {
    auto &[equilibrium,
           body_equilibrium,
           penetration,
           tension,
           cone,
           complementarity,
           slip_direction,
           layer_law,
           energy] = certificate;
    visit("equilibrium", equilibrium);
    visit("body_equilibrium", body_equilibrium);
    visit("penetration", penetration);
    visit("tension", tension);
    visit("cone", cone);
    visit("complementarity", complementarity);
    visit("slip_direction", slip_direction);
    visit("layer_law", layer_law);
    visit("energy", energy);
  }
} // namespace fuga

#endif
