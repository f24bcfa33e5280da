// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_return_mapping_h
#define fuga_contact_element_return_mapping_h

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/system/tangent_solver.h>

namespace fuga
{
  /** What an element does at the end of a step that has led to given jumps. */
  struct StepResponse
  {
    ContactState state = ContactState::open;
    /** Bar forces N, T1, T2 [MN], and their derivatives by the jumps [MN/m]. */
    std::array<double, 3> forces{};
    ElementStiffness tangent{};
    /** What has slipped in all, and how far the lips have risen [m]. */
    TangentVector slip{};
    double dilation = 0.;
  };

  /**
   * The forces of contact elements as functions of their jumps at the end of a step, with the
   * strengths at its beginning: closed layers answer gap and elastic shear e by N(g, e) and
   * T(g, e); where |T| would exceed the shear strength the lips slip by γ along T and rise by
   * γ tan ψ, so that it does not (doc/theory.md, section 18, eq. 32). Only for layers with a
   * compliance. A bond holds whatever its force: whether it breaks is asked when equilibrium is
   * found.
   */
  class ReturnMapping
  {
  public:
    /** @p from: the beginning of the step. @p jumps: of all bars, at its end. */
    ReturnMapping(const std::vector<ContactElement> &elements,
                  const JointState &from,
                  const Vector &jumps);

    StepResponse
    respond(const std::size_t k);

  private:
    /** Forces of a closed layer, the shear along the elastic deformation, and their derivatives. */
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
    /** The response where the elastic shear would be @p e without slip, which is too much. */
    void
    slip(const std::size_t k, const TangentVector &e, StepResponse &result);
    double
    slip_onto_strength(const std::size_t k, const TangentVector &e);

    const std::vector<ContactElement> &elements;
    const JointState &from;
    /** Without forces the dislocations of this state are the jumps; all elements stick. */
    JointState at;
  };
} // namespace fuga

#endif
