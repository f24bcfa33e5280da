// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/secant_factors.h>

namespace fuga
{
  NearlyTriangularFactors::NearlyTriangularFactors(const DenseMatrix &jacobian,
                                                   const std::vector<bool> &is_weak)
  {
    for (std::size_t i = 0; i < is_weak.size(); ++i)
      (is_weak[i] ? weak : strong).push_back(i);
    rows = jacobian(weak, strong);
    for (const std::size_t i : weak)
      diagonal.push_back(jacobian(i, i));
    factors.emplace(jacobian(strong, strong));
  }

  Vector
  NearlyTriangularFactors::solve(const Vector &right_hand_side) const
  {
    Vector of_strong, result(right_hand_side.size());
    for (const std::size_t i : strong)
      of_strong.push_back(right_hand_side[i]);
    factors->solve(of_strong);
    for (std::size_t j = 0; j < strong.size(); ++j)
      result[strong[j]] = of_strong[j];
    const Vector known = weak.empty() ? Vector() : multiply(rows, of_strong);
    for (std::size_t i = 0; i < weak.size(); ++i)
      result[weak[i]] = (right_hand_side[weak[i]] - known[i]) / diagonal[i];
    return result;
  }

  // A step that has gained almost nothing shows that the factors are of no use.
  Vector
  SecantFactors::solve(const Vector &residual, const Vector &last_step)
  {
    constexpr std::size_t most  = 30;
    constexpr double least_gain = 0.2;
    Vector result               = factors->solve(residual);
    const auto correct          = [&result](const Correction &correction) {
      add_multiple(dot(correction.step, result) / correction.gain, correction.missed, result);
    };
    for (const Correction &correction : corrections)
      correct(correction);
    if (last_step.empty())
      return result;
    const double size = dot(last_step, last_step), gain = size - dot(last_step, result);
    if (gain < least_gain * size)
      return result;
    if (corrections.size() == most)
      corrections.clear();
    corrections.push_back({last_step, result, gain});
    correct(corrections.back());
    return result;
  }
} // namespace fuga
