// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/half_plane.h"

#include <cmath>
#include <stdexcept>

namespace fuga::tests
{
  namespace
  {
    /** ∫ ln|s| ds. */
    double
    integral_of_log(const double s)
    {
      return s == 0. ? 0. : s * std::log(std::abs(s)) - s;
    }
  } // namespace

  // Flexibility C (approach by forces), with ln|x - s|/L in place of ln|x - s|: L changes the
  // constant only, and makes C positive definite. Free motion d and the force P: δ = C p - d, 1·p =
  // P.
  HalfPlanes::HalfPlanes(const std::size_t n, const double length, const double modulus)
    : h(length / static_cast<double>(n))
  {
    for (std::size_t i = 0; i < n; ++i)
      x.push_back((static_cast<double>(i) + 0.5) * h - 0.5 * length);
    DenseMatrix C(n, n), K(n, n);
    for (std::size_t i = 0; i < n; ++i)
      {
        K(i, i) = 1.;
        for (std::size_t j = 0; j < n; ++j)
          {
            const double s        = x[i] - x[j];
            const double integral = integral_of_log(s + 0.5 * h) - integral_of_log(s - 0.5 * h);
            C(i, j)               = 2. / (M_PI * modulus) * (std::log(10. * length) - integral / h);
          }
      }
    if (!solve_positive_definite(C, K))
      throw std::logic_error("the flexibility of the half-plane is not positive definite");

    const Vector forces_of_motion = multiply(K, Vector(n, 1.));
    double stiffness              = 0.;
    for (const double force : forces_of_motion)
      stiffness += force;
    system.S            = DenseMatrix(2 * n, 2 * n);
    system.F            = DenseMatrix(2 * n, 2);
    system.motions      = DenseMatrix(2 * n, 2);
    system.motion_loads = DenseMatrix(2, 2);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
          system.S(2 * i, 2 * j) = system.S(2 * i + 1, 2 * j + 1) =
            0.5 * (K(i, j) + K(j, i)) - forces_of_motion[i] * forces_of_motion[j] / stiffness;
        system.F(2 * i, 0)           = -forces_of_motion[i] / stiffness;
        system.F(2 * i + 1, 1)       = forces_of_motion[i] / stiffness;
        system.motions(2 * i, 0)     = 1.;
        system.motions(2 * i + 1, 1) = 1.;
      }
    system.motion_loads(0, 0) = -1.;
    system.motion_loads(1, 1) = 1.;
  }
} // namespace fuga::tests
