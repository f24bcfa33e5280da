// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_return_mapping_h
#define fuga_contact_element_return_mapping_h

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/system/tangent_solver.h>

namespace fuga
{
  /** The response of an element at the end of a step that has led to given jumps. */
  struct StepResponse
  {
    ContactState state = ContactState::open;
    /** Bar forces N, T1, T2 [MN], and their derivatives by the jumps [MN/m]. */
    std::array<double, 3> forces{};
    ElementStiffness tangent{};
    /** Total slip, and total rise of the lips [m]. */
    TangentVector slip{};
    double dilation = 0.;
  };

  /**
   * The forces of contact elements as functions of their jumps at the end of a step, with the
   * strengths at its beginning. Closed layers answer gap and elastic shear e by N(g, e) and T(g,
   * e). Where |T| would exceed the shear strength the lips slip by γ along T and rise by γ tan ψ,
   * so that it does not (doc/theory.md, section 18, eq. 32). This works only for layers with a
   * compliance. A bond holds whatever its force; whether it breaks is decided when equilibrium has
   * been found.
   */
  class ReturnMapping
  {
  public:
    /** Constructor. @p from is the beginning of the step, @p jumps are those of all bars at its
     * end. */
    ReturnMapping(const std::vector<ContactElement> &elements,
                  const JointState &from,
                  const Vector &jumps);

    StepResponse
    respond(const std::size_t k);

  private:
    /** Normal force of a closed layer, its shear along the elastic deformation, and their
     * derivatives. */
    struct Layer
    {
      double normal = 0., shear = 0.;
      LayerTangent tangent;
    };

    Layer
    layer(const std::size_t k) const;
    bool
    may_rise(const std::size_t k) const;
    void
    slide(const std::size_t k, const TangentVector &by);
    /** Compute the response where the elastic shear would be @p e without slip, which exceeds the
     * strength. */
    void
    slip(const std::size_t k, const TangentVector &e, StepResponse &result);
    double
    slip_onto_strength(const std::size_t k, const TangentVector &e);

    const std::vector<ContactElement> &elements;
    const JointState &from;
    /** The state at the end of the step, without forces, so that its dislocations are the jumps;
     * all elements stick. */
    JointState at;
  };
} // namespace fuga

#endif
