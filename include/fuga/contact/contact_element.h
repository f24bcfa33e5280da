// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_contact_element_h
#define fuga_contact_contact_element_h

#include <fuga/laws/compliance_law.h>
#include <fuga/laws/friction_law.h>
#include <fuga/laws/shear_coupling.h>

#include <algorithm>
#include <array>
#include <vector>

namespace fuga
{
  /**
   * The paper's frame-bar contact element: a normal and a tangential bar (in 3D: two) between the
   * two nodes of a pair. The structure contains data only; the state, the forces and the jumps are
   * stored in ContactState and JointState.
   */
  struct ContactElement
  {
    /** Marks an element without a tangential bar (frictionless). */
    static constexpr unsigned int no_bar = static_cast<unsigned int>(-1);

    /** Row of the normal bar in the contact system. */
    unsigned int normal_bar = no_bar;
    /** Row of the tangential bar, or no_bar. */
    unsigned int tangential_bar = no_bar;
    /** Row of the bar along the second tangent in 3D; no_bar in 2D and without friction. The normal
     * and both tangents form a right-handed orthonormal frame n = t1 x t2. */
    unsigned int second_tangential_bar = no_bar;
    /** The number of the joint, and the number of the element within it (counted along the
     * joint). */
    unsigned int joint  = 0;
    unsigned int number = 0;
    /** Position of the element [m]. */
    std::array<double, 3> position = {{0., 0., 0.}};
    /** Tributary area A > 0 [m²]. */
    double area = 1.;
    /** Gap in the unloaded state, ≥ 0 [m]. */
    double initial_gap = 0.;
    /** Laws of the layer; the joint owns them. */
    const ComplianceLaw *normal_law = nullptr;
    const ComplianceLaw *shear_law  = nullptr;
    /** The coupling that replaces both laws if the shear stiffness grows with closure or pressure;
     * the laws then only give the compliances. */
    const ShearCoupling *coupling = nullptr;
    FrictionLaw friction;

    bool
    has_tangential_bar() const
    {
      return tangential_bar != no_bar;
    }

    bool
    has_second_tangential_bar() const
    {
      return second_tangential_bar != no_bar;
    }

    /** Return the normal bar (i = 0), the tangential one (1) or the second tangential one (2), or
     * no_bar. */
    unsigned int
    bar(const std::size_t i) const
    {
      return i == 0 ? normal_bar : i == 1 ? tangential_bar : second_tangential_bar;
    }

    unsigned int
    n_bars() const
    {
      return has_second_tangential_bar() ? 3 : has_tangential_bar() ? 2 : 1;
    }

    /** Call @p action(bar, law of its layer) for every bar. */
    template <typename Action>
    void
    for_each_bar(Action &&action) const
    {
      action(normal_bar, *normal_law);
      if (has_tangential_bar())
        action(tangential_bar, *shear_law);
      if (has_second_tangential_bar())
        action(second_tangential_bar, *shear_law);
    }
  };
  /** Return whether any element has two tangential bars, i.e. friction with a circular cone. */
  inline bool
  have_two_tangents(const std::vector<ContactElement> &elements)
  {
    return std::any_of(elements.begin(), elements.end(), [](const ContactElement &element) {
      return element.has_second_tangential_bar();
    });
  }

  /** Return whether the strength of any element is a curve over the pressure. */
  inline bool
  has_curved_envelope(const std::vector<ContactElement> &elements)
  {
    return std::any_of(elements.begin(), elements.end(), [](const ContactElement &element) {
      return element.friction.envelope.is_curved();
    });
  }

  /**
   * Return whether the shear of an element can differ from zero with the remaining @p strength.
   * This matters only for elements with two tangential bars: with one, an element without strength
   * slips.
   */
  inline bool
  carries_shear(const ContactElement &element, const Strength &strength)
  {
    return element.has_tangential_bar() &&
           (!element.has_second_tangential_bar() || strength.resists_shear());
  }
} // namespace fuga

#endif
