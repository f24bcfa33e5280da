// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/layer_response.h>
#include <fuga/contact/layered_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  bool
  has_nonlinear_closure(const ContactElement &element)
  {
    return element.normal_law->kind() == ComplianceKind::nonlinear;
  }

  bool
  has_nonlinear_shear(const ContactElement &element)
  {
    return element.has_tangential_bar() && element.shear_law->kind() == ComplianceKind::nonlinear;
  }

  double
  gap(const ContactElement &element, const JointState &at)
  {
    const std::size_t n = element.normal_bar;
    return element.initial_gap + at.dislocations[n] +
           bar_compliance(*element.normal_law, element.area) * at.forces[n];
  }

  double
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t t = element.tangential_bar;
    return at.dislocations[t] + bar_compliance(*element.shear_law, element.area) * at.forces[t] -
           at.slips[k];
  }

  double
  normal_force(const ContactElement &element, const JointState &at)
  {
    const double g = gap(element, at);
    return g < 0. ? -element.area * element.normal_law->stress(-g)
                  : element.area * g / element.normal_law->initial_compliance();
  }

  double
  normal_stiffness(const ContactElement &element, const JointState &at)
  {
    const double g = gap(element, at);
    return element.area * (g < 0. ? element.normal_law->tangent(-g)
                                  : 1. / element.normal_law->initial_compliance());
  }

  double
  shear_force(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double e = elastic_shear(element, at, k);
    return std::copysign(element.area * element.shear_law->stress(std::abs(e)), e);
  }

  double
  shear_stiffness(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return element.area * element.shear_law->tangent(std::abs(elastic_shear(element, at, k)));
  }

  double
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates)
  {
    const std::size_t t = element.tangential_bar;
    if (!has_nonlinear_shear(element))
      return rates.dislocations[t];
    return rates.dislocations[t] + (bar_compliance(*element.shear_law, element.area) -
                                    1. / shear_stiffness(element, at, k)) *
                                     rates.forces[t];
  }

  double
  cohesive_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return at.broken[k] ? std::abs(at.unreleased_shear[k])
                        : element.friction.cohesion * element.area;
  }

  double
  shear_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double pressing = std::max(-at.forces[element.normal_bar], 0.);
    return element.friction.coefficient * pressing + cohesive_strength(element, at, k);
  }

  double
  cohesive_strength_rate(const Drive &drive, const std::size_t k)
  {
    return drive.release.empty() ? 0. : -std::abs(drive.release[k]);
  }
} // namespace fuga
