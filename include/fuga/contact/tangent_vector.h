// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_tangent_vector_h
#define fuga_contact_tangent_vector_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/contact/contact_element.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fuga
{
  /** A vector in the tangent plane of an element, in the directions of its tangential bars. */
  using TangentVector = std::array<double, 2>;

  /** Return a + factor b. */
  inline TangentVector
  sum(const TangentVector &a, const double factor, const TangentVector &b)
  {
    return {{a[0] + factor * b[0], a[1] + factor * b[1]}};
  }

  inline double
  dot(const TangentVector &a, const TangentVector &b)
  {
    return a[0] * b[0] + a[1] * b[1];
  }

  /** Return a turned by a right angle. */
  inline TangentVector
  normal_to(const TangentVector &a)
  {
    return {{-a[1], a[0]}};
  }

  inline double
  length(const TangentVector &a)
  {
    return std::hypot(a[0], a[1]);
  }

  /** Return the unit vector along a; where a is zero, the first tangent. */
  inline TangentVector
  direction_of(const TangentVector &a)
  {
    const double size = length(a);
    return size > 0. ? TangentVector{{a[0] / size, a[1] / size}} : TangentVector{{1., 0.}};
  }

  /** Return the part of a bar vector that lies in the tangent plane of an element; where only one
   * tangential bar is free, the second component is zero. */
  inline TangentVector
  tangential(const ContactElement &element, const Vector &of_bars)
  {
    return {{of_bars[element.tangential_bar],
             element.has_second_tangential_bar() ? of_bars[element.second_tangential_bar] : 0.}};
  }

  /** Return the largest jump of all elements, across or along the joint, whatever the directions of
   * the tangents are. */
  inline double
  largest_jump(const std::vector<ContactElement> &elements, const Vector &jumps)
  {
    double largest = 0.;
    for (const ContactElement &element : elements)
      {
        largest = std::max(largest, std::abs(jumps[element.normal_bar]));
        if (element.has_tangential_bar())
          largest = std::max(largest, length(tangential(element, jumps)));
      }
    return largest;
  }
} // namespace fuga

#endif
