// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/cubic.h>
#include <fuga/contact/certificate.h>

#include <algorithm>
#include <cmath>

// What the judge asks of elements with two tangential bars. Their layers are linear.
namespace fuga
{
  double
  Judge::shear_force(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    if (!element.has_tangential_bar())
      return 0.;
    const double T = state.forces[element.tangential_bar];
    return element.has_second_tangential_bar()
             ? std::hypot(T, state.forces[element.second_tangential_bar])
             : T;
  }

  // ∫T·ds as in check_slip(). A stuck element must not slip, and a slipping one slips along its
  // force: at both ends and in the middle of the piece, where the slopes of the cubics are best,
  // the part of the slip across the force times the force counts as wrong work.
  void
  Judge::check_slip_in_plane(const std::size_t k,
                             const PathPoint &from,
                             const PathPoint &to,
                             const double length)
  {
    const ContactElement &element         = elements[k];
    const std::array<std::size_t, 2> bars = {
      {element.tangential_bar, element.second_tangential_bar}};
    const auto along =
      [&](const Vector JointState::*value, const Vector JointRates::*rate, const std::size_t bar) {
        return CubicOnUnitInterval((from.state.*value)[bar],
                                   (from.rates.*rate)[bar] * length,
                                   (to.state.*value)[bar],
                                   (to.rates.*rate)[bar] * length);
      };
    std::vector<CubicOnUnitInterval> T, s;
    for (const std::size_t bar : bars)
      {
        T.push_back(along(&JointState::forces, &JointRates::forces, bar));
        // What the jump has beyond the deformation D T of the linear layer.
        s.push_back(along(&JointState::dislocations, &JointRates::dislocations, bar));
      }
    if (from.state.states[k] == ContactState::stick)
      {
        if (from.state.strengths[k].friction > 0.)
          for (const CubicOnUnitInterval &slip : s)
            wrong_rise = std::max(wrong_rise, std::abs(slip.value(1.) - slip.value(0.)));
        return;
      }

    const double r           = std::sqrt(0.15);
    const double abscissae[] = {0.5 - r, 0.5, 0.5 + r};
    const double weights[]   = {5. / 18., 8. / 18., 5. / 18.};
    double work              = 0.;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j)
        work += weights[i] * T[j].value(abscissae[i]) * s[j].slope(abscissae[i]);
    for (const double x : {0., 0.5, 1.})
      {
        const double across = T[0].value(x) * s[1].slope(x) - T[1].value(x) * s[0].slope(x);
        wrong_slip_work     = std::max(wrong_slip_work, std::abs(across));
      }
    ledger.dissipation += work;
    element_dissipation[k] += work;
    largest_slip_work = std::max(largest_slip_work, std::abs(work));
    wrong_slip_work   = std::max(wrong_slip_work, -work);
  }
} // namespace fuga
