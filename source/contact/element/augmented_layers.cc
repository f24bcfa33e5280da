// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/augmented_layers.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Of the compliance of a layer taken for rigid to that of its lips: the error falls by this
     * factor, and as many digits of jumps are lost to forces. */
    constexpr double share_of_lips = 0.1;
  } // namespace

  AugmentedLayers::AugmentedLayers(const std::vector<ContactElement> &elements, const Vector &lips)
    : compliant(elements)
  {
    const auto soften = [&](const ContactElement &element,
                            const ComplianceLaw *&law,
                            const std::vector<unsigned int> &of_law) {
      if (law->kind() != ComplianceKind::rigid)
        return;
      double stiffness = 0.;
      for (const unsigned int bar : of_law)
        stiffness = std::max(stiffness, lips[bar]);
      const double compliance = share_of_lips / stiffness;
      laws.push_back(make_linear_law(compliance * element.area));
      law = laws.back().get();
      for (const unsigned int bar : of_law)
        bars.push_back({bar, compliance, 0.});
    };
    for (ContactElement &element : compliant)
      {
        soften(element, element.normal_law, {element.normal_bar});
        if (element.has_second_tangential_bar())
          soften(
            element, element.shear_law, {element.tangential_bar, element.second_tangential_bar});
        else if (element.has_tangential_bar())
          soften(element, element.shear_law, {element.tangential_bar});
      }
  }

  void
  AugmentedLayers::update(const Vector &forces)
  {
    for (RigidBar &rigid : bars)
      rigid.known_force = forces[rigid.bar];
  }

  void
  AugmentedLayers::enlarge(Vector &jumps) const
  {
    for (const RigidBar &rigid : bars)
      jumps[rigid.bar] += rigid.compliance * rigid.known_force;
  }

  double
  AugmentedLayers::defect(const Vector &forces) const
  {
    double worst = 0.;
    for (const RigidBar &rigid : bars)
      worst = std::max(worst, std::abs(forces[rigid.bar] - rigid.known_force));
    return share_of_lips * worst;
  }
} // namespace fuga
