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
                            const std::size_t first,
                            const std::size_t last) {
      if (first == last || law->kind() != ComplianceKind::rigid)
        return;
      double stiffness = 0.;
      for (std::size_t i = first; i < last; ++i)
        stiffness = std::max(stiffness, lips[element.bar(i)]);
      const double compliance = share_of_lips / stiffness;
      laws.push_back(make_linear_law(compliance * element.area));
      law = laws.back().get();
      for (std::size_t i = first; i < last; ++i)
        bars.push_back({element.bar(i), compliance, 0.});
    };
    for (ContactElement &element : compliant)
      {
        soften(element, element.normal_law, 0, 1);
        soften(element, element.shear_law, 1, element.n_bars());
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
