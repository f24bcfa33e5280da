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
   * Rigid and very stiff layers whose forces have to be functions of the jumps: an augmented
   * Lagrangian method (doc/theory.md, section 18). A layer of the compliance D, zero if it is
   * rigid, is replaced by one of a small compliance D + c that feels its jump enlarged by c p̂,
   * where p̂ [MN] is the known estimate of its force p. If p̂ = p the layer is the original one,
   * and the update p̂ := p comes closer to that by a factor of about c times the stiffness of the
   * bodies, which is bounded by that of their lips.
   */
  class AugmentedLayers
  {
  public:
    /**
     * Constructor. @p lips contains for every bar a bound of the stiffness of the bodies against
     * its jump [MN/m]. Where the @p jump_operator has more bars than coordinates, bars with a
     * compliance remain as they are: they share their forces according to it, and hold the rigid
     * ones there.
     */
    AugmentedLayers(const std::vector<ContactElement> &elements,
                    const Vector &lips,
                    const SparseOperator &jump_operator);

    /** Return the elements, with a compliance in every layer. */
    const std::vector<ContactElement> &
    elements() const
    {
      return compliant;
    }

    /** Set the forces p̂ of stiff layers from @p forces of all bars. */
    void
    update(const Vector &forces);

    /** Add c p̂ to the jumps of the bars of stiff layers. */
    void
    enlarge(Vector &jumps) const;

    /** Return the largest force [MN] that the bodies may feel from the excess deformation of stiff
     * layers under @p forces. */
    double
    defect(const Vector &forces) const;

  private:
    struct StiffBar
    {
      unsigned int bar;
      /** c [m/MN] and p̂ [MN]. */
      double added_compliance, known_force;
    };

    std::vector<ContactElement> compliant;
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    std::vector<StiffBar> bars;
  };
} // namespace fuga

#endif
