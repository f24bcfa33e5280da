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
   * positive in opening, N positive in tension, so that N = -A σ(w), w = -gap. In LayeredSystem, a
   * *nonlinear* bar has only the reference_compliance() of its law; the rest of its deformation is
   * its dislocation. With a shear coupling both bars are nonlinear.
   */
  bool
  has_nonlinear_closure(const ContactElement &element);
  bool
  has_nonlinear_shear(const ContactElement &element);

  /** Return the deformation of the layer that no finite force reaches [m]. */
  double
  closure_limit(const ContactElement &element);

  /** Return whether the closure of element @p k differs from closure_limit() by less than 1e-8 of
   * it: no law is meant to be used there, and Newton's method has few digits left. */
  bool
  is_at_closure_limit(const ContactElement &element, const JointState &at, const std::size_t k);

  /**
   * Return the gap g = initial gap + normal jump - dilation [m] of element @p k: the distance of
   * the lips where they are apart, minus the closure of the layer where they touch.
   */
  double
  gap(const ContactElement &element, const JointState &at, const std::size_t k);

  /**
   * Return the part of the gap of an open element that remains after subtracting the deformation of
   * its layer, which is still stretched or sheared by the forces that a broken bond has not yet
   * released [m]. The lips meet where it is zero.
   */
  double
  lip_opening(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the rate of lip_opening() [m per unit of the path]. */
  double
  lip_opening_rate(const ContactElement &element, const JointState &at, const JointRates &rates);

  /** Return the elastic shear deformation of the layer, jump - slip [m]. */
  TangentVector
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the elastic shear deformation that belongs to the present shear force (and gap), along
   * that force [m]. */
  TangentVector
  shear_deformation(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the slip of an element that slips or is open: the part of the jump that is not
   * deformation of its layer [m]. */
  TangentVector
  present_slip(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Bar forces of a layer [MN]; N, T are zero where the respective bar is rigid or linear. */
  struct LayerForces
  {
    double normal       = 0.;
    TangentVector shear = {{0., 0.}};
  };

  /** Return N_law, T_law at the present gap and elastic shear; the laws are continued linearly into
   * tension so that Newton's method can cross zero. */
  LayerForces
  layer_forces(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the energy stored in the nonlinear bars of an element [MNm]; where the lips are apart,
   * in those of shear. */
  double
  nonlinear_energy(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Derivatives of these forces [MN/m]. The layer is isotropic in its plane. */
  struct LayerTangent
  {
    /** dN/d(gap); dN/d(length of the elastic shear) = dT/d(gap), with T along the shear;
     * dT/d(length), with T along the shear. */
    double normal = 0., mixed = 0., shear = 0.;
    /** Derivative of T across the elastic shear by the shear across it, i.e. the secant
     * stiffness. */
    double across = 0.;
    /** Direction of the elastic shear. */
    TangentVector direction = {{1., 0.}};

    /** Return an entry of the matrix, in the order of the bars: normal, first tangent, second
     * tangent. */
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

  /** Return the derivatives at zero deformation. */
  LayerTangent
  initial_layer_tangent(const ContactElement &element);

  /** Return the rate of slip ṡ of an element that slips or is open, computed from the rates of its
   * bars [m per unit of the path]. */
  TangentVector
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates);
} // namespace fuga

#endif
