// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_augmented_layers_h
#define fuga_contact_element_augmented_layers_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/contact/contact_element.h>

#include <memory>

namespace fuga
{
  /**
   * Rigid layers whose forces are to be functions of the jumps: an augmented Lagrangian method
   * (doc/theory.md, section 18). A rigid layer is taken for one of a small compliance c that feels
   * its jump enlarged by c p̂, with p̂ [MN] what is known of its force p. Where p̂ = p the layer is
   * rigid, and p̂ := p comes closer to that by a factor of about c times the stiffness of the
   * bodies, which their lips bound.
   */
  class AugmentedLayers
  {
  public:
    /** @p lips: for every bar a bound of the stiffness of the bodies against its jump [MN/m]. */
    AugmentedLayers(const std::vector<ContactElement> &elements, const Vector &lips);

    /** The elements with a compliance in every layer. */
    const std::vector<ContactElement> &
    elements() const
    {
      return compliant;
    }

    /** Takes the forces of rigid layers from @p forces of all bars. */
    void
    update(const Vector &forces);

    /** Adds c p̂ to the jumps of the bars of rigid layers. */
    void
    enlarge(Vector &jumps) const;

    /** Largest force that the bodies may feel of what rigid layers still deform under @p forces
     * [MN]. */
    double
    defect(const Vector &forces) const;

  private:
    struct RigidBar
    {
      unsigned int bar;
      /** c [m/MN], and p̂ [MN]. */
      double compliance, known_force;
    };

    std::vector<ContactElement> compliant;
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    std::vector<RigidBar> bars;
  };
} // namespace fuga

#endif
