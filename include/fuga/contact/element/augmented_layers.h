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
   * Rigid and very stiff layers whose forces are to be functions of the jumps: an augmented
   * Lagrangian method (doc/theory.md, section 18). A layer of the compliance D, zero if it is
   * rigid, is taken for one of a small compliance D + c that feels its jump enlarged by c p̂, with p̂
   * [MN] what is known of its force p. Where p̂ = p the layer is as it was, and p̂ := p comes closer
   * to that by a factor of about c times the stiffness of the bodies, which their lips bound.
   */
  class AugmentedLayers
  {
  public:
    /**
     * @p lips: for every bar a bound of the stiffness of the bodies against its jump [MN/m]. Bars
     * with a compliance stay as they are where the @p jump_operator has more bars than coordinates:
     * they share their forces by it, and hold the rigid ones there.
     */
    AugmentedLayers(const std::vector<ContactElement> &elements,
                    const Vector &lips,
                    const SparseOperator &jump_operator);

    /** The elements with a compliance in every layer. */
    const std::vector<ContactElement> &
    elements() const
    {
      return compliant;
    }

    /** Takes the forces of stiff layers from @p forces of all bars. */
    void
    update(const Vector &forces);

    /** Adds c p̂ to the jumps of the bars of stiff layers. */
    void
    enlarge(Vector &jumps) const;

    /** Largest force that the bodies may feel of what stiff layers still deform too much under @p
     * forces [MN]. */
    double
    defect(const Vector &forces) const;

  private:
    struct StiffBar
    {
      unsigned int bar;
      /** c [m/MN], and p̂ [MN]. */
      double added_compliance, known_force;
    };

    std::vector<ContactElement> compliant;
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    std::vector<StiffBar> bars;
  };
} // namespace fuga

#endif
