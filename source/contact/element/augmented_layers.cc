// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/augmented_layers.h>
#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Ratio of the compliance that a stiff layer gets to that of its lips: the error decreases by
     * this factor, and as many digits of jumps are lost in the forces. */
    constexpr double share_of_lips = 0.1;

    /** Return for every bar, where joints cross or have corners, the stiffness of all bars there
     * that have a compliance [MN/m]; elsewhere zero. */
    Vector
    stiffness_at_crossings(const std::vector<ContactElement> &elements,
                           const SparseOperator &jump_operator)
    {
      Vector of_bars(jump_operator.n_rows(), 0.), result = of_bars;
      if (jump_operator.is_identity())
        return result;
      for (const ContactElement &element : elements)
        element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
          const double compliance = bar_compliance(law, element.area);
          of_bars[bar]            = compliance > 0. ? 1. / compliance : 0.;
        });
      for (const SparseBlock &block : blocks_of(jump_operator))
        if (block.rows.size() > block.columns.size())
          {
            double sum = 0.;
            for (const std::size_t bar : block.rows)
              sum += of_bars[bar];
            for (const std::size_t bar : block.rows)
              result[bar] = sum;
          }
      return result;
    }
  } // namespace

  AugmentedLayers::AugmentedLayers(const std::vector<ContactElement> &elements,
                                   const Vector &lips,
                                   const SparseOperator &jump_operator)
    : compliant(elements)
  {
    const Vector at_crossings = stiffness_at_crossings(elements, jump_operator);
    const auto soften         = [&](const ContactElement &element,
                            const ComplianceLaw *&law,
                            const std::size_t first,
                            const std::size_t last) {
      if (first == last || law->kind() == ComplianceKind::nonlinear || element.coupling != nullptr)
        return;
      double stiffness = 0., at_crossing = 0.;
      for (std::size_t i = first; i < last && !at_crossings.empty(); ++i)
        at_crossing = std::max(at_crossing, at_crossings[element.bar(i)]);
      if (law->kind() != ComplianceKind::rigid && at_crossing > 0.)
        return;
      for (std::size_t i = first; i < last; ++i)
        stiffness = std::max(stiffness, lips[element.bar(i)] + at_crossing);
      const double compliance = share_of_lips / stiffness;
      const double added      = compliance - bar_compliance(*law, element.area);
      if (added <= 0.)
        return;
      laws.push_back(make_linear_law(compliance * element.area));
      law = laws.back().get();
      for (std::size_t i = first; i < last; ++i)
        bars.push_back({element.bar(i), added, 0.});
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
    for (StiffBar &stiff : bars)
      stiff.known_force = forces[stiff.bar];
  }

  void
  AugmentedLayers::enlarge(Vector &jumps) const
  {
    for (const StiffBar &stiff : bars)
      jumps[stiff.bar] += stiff.added_compliance * stiff.known_force;
  }

  double
  AugmentedLayers::defect(const Vector &forces) const
  {
    double worst = 0.;
    for (const StiffBar &stiff : bars)
      worst = std::max(worst, std::abs(forces[stiff.bar] - stiff.known_force));
    return share_of_lips * worst;
  }
} // namespace fuga
