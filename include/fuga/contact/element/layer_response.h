// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_layer_response_h
#define fuga_contact_element_layer_response_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

namespace fuga
{
  /**
   * The force-deformation relations of one element's layer, with the signs of the bars: gap
   * positive in opening, N positive in tension, so that N = -A σ(w), w = -gap. A *nonlinear* bar
   * has in LayeredSystem only the reference_compliance() of its law; its dislocation is the rest.
   * With a shear coupling both bars are nonlinear.
   */
  bool
  has_nonlinear_closure(const ContactElement &element);
  bool
  has_nonlinear_shear(const ContactElement &element);

  /** Deformation of the layer that no finite force reaches [m]. */
  double
  closure_limit(const ContactElement &element);

  /** Whether the closure of element @p k differs from that by less than 1e-8 of it: no law is meant
   * to be used there, and Newton's method has few digits left. */
  bool
  is_at_closure_limit(const ContactElement &element, const JointState &at, const std::size_t k);

  /**
   * Gap g = initial gap + normal jump - dilation [m] of element @p k: between the lips where they are
   * apart, minus the closure of the layer where they touch.
   */
  double
  gap(const ContactElement &element, const JointState &at, const std::size_t k);

  /**
   * What is left of the gap of an open element when its layer, still stretched or sheared by what a
   * broken bond has not yet released, is taken off [m]: the lips meet where it is zero.
   */
  double
  lip_opening(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Its rate [m per unit of the path]. */
  double
  lip_opening_rate(const ContactElement &element, const JointState &at, const JointRates &rates);

  /** Elastic shear deformation of the layer, jump - slip [m]. */
  TangentVector
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Elastic shear deformation that belongs to the present shear force (and gap), along it [m]. */
  TangentVector
  shear_deformation(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Slip of an element that slips or is open: what its layer does not deform of the jump [m]. */
  TangentVector
  present_slip(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Bar forces of a layer [MN]; N, T are zero where the respective bar is rigid or linear. */
  struct LayerForces
  {
    double normal       = 0.;
    TangentVector shear = {{0., 0.}};
  };

  /** N_law, T_law at the present gap and elastic shear; continued linearly into tension so that
   * Newton can cross zero. */
  LayerForces
  layer_forces(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Energy stored in the nonlinear bars of an element [MNm]; where the lips are apart, in those of
   * shear. */
  double
  nonlinear_energy(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Derivatives of these forces [MN/m]. The layer is isotropic in its plane. */
  struct LayerTangent
  {
    /** N by the gap; N by the length of the elastic shear = T along it by the gap; T along it by
     * its length. */
    double normal = 0., mixed = 0., shear = 0.;
    /** T across the elastic shear by the shear across: the secant stiffness. */
    double across = 0.;
    /** Direction of the elastic shear. */
    TangentVector direction = {{1., 0.}};

    /** Entry of the matrix in the order of the bars: normal, first tangent, second tangent. */
    double
    operator()(const std::size_t i, const std::size_t j) const
    {
      if (i == 0 || j == 0)
        return i == j ? normal : mixed * direction[i + j - 1];
      return (i == j ? across : 0.) + (shear - across) * direction[i - 1] * direction[j - 1];
    }
  };

  LayerTangent
  layer_tangent(const ContactElement &element, const JointState &at, const std::size_t k);

  /** The derivatives at zero deformation. */
  LayerTangent
  initial_layer_tangent(const ContactElement &element);

  /** Rate of slip ṡ of an element that slips or is open, from the rates of its bars [m per unit of
   * the path]. */
  TangentVector
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates);

  /** What does not depend on the pressure in the shear strength [MN]: cA, or T_u + f N_u of the
   * shear and the tension that a broken bond has not yet released. */
  double
  cohesive_strength(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Largest shear the element can carry if its normal force is @p N, cohesive strength - f N [MN].
   */
  double
  shear_strength(const ContactElement &element,
                 const JointState &at,
                 const std::size_t k,
                 const double N);

  /** The same with the normal force that it has. */
  inline double
  shear_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return shear_strength(element, at, k, at.forces[element.normal_bar]);
  }

  /** Largest tension the element can carry while closed, σ_t A and what a broken bond has not yet
   * released [MN]. */
  double
  tensile_strength(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Rate of the tensile strength under a drive. */
  double
  tensile_strength_rate(const ContactElement &element, const Drive &drive);

  /** Rate of the shear strength under a drive, N and the coefficient of friction given. */
  double
  shear_strength_rate(const ContactElement &element, const double friction, const Drive &drive);
} // namespace fuga

#endif
