// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/joint_water.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Row of a bar of @p matrix times @p factors. */
    double
    row_product(const DenseMatrix &matrix, const std::size_t bar, const Vector &factors)
    {
      double sum = 0.;
      for (std::size_t j = 0; j < factors.size(); ++j)
        sum += matrix(bar, j) * factors[j];
      return sum;
    }

    bool
    has_water(const DenseMatrix &matrix, const std::size_t bar)
    {
      for (std::size_t j = 0; j < matrix.n_columns(); ++j)
        if (matrix(bar, j) != 0.)
          return true;
      return false;
    }
  } // namespace

  void
  set_water(const std::vector<ContactElement> &elements,
            const LayeredSystem &system,
            const Vector &factors,
            JointState &state)
  {
    if (system.opening_water().empty())
      return;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const std::size_t n = elements[k].normal_bar;
        const double full   = state.states[k] == ContactState::open
                                ? row_product(system.opening_water(), n, factors)
                                : 0.;
        state.water[n]      = full - state.missing_water[n];
      }
  }

  void
  keep_water(const ContactElement &element,
             const std::size_t k,
             const LayeredSystem &system,
             const Vector &factors,
             const double no_force,
             JointState &state)
  {
    if (system.opening_water().empty())
      return;
    const std::size_t n = element.normal_bar;
    const double full =
      state.states[k] == ContactState::open ? row_product(system.opening_water(), n, factors) : 0.;
    const double missing   = full - state.water[n];
    state.missing_water[n] = std::abs(missing) > no_force ? missing : 0.;
  }

  bool
  water_has_changed(const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const std::vector<ContactState> &before,
                    const JointState &state)
  {
    if (system.opening_water().empty())
      return false;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if ((before[k] == ContactState::open) != (state.states[k] == ContactState::open) &&
          has_water(system.opening_water(), elements[k].normal_bar))
        return true;
    return false;
  }

  void
  add_water_rates(const std::vector<ContactElement> &elements,
                  const LayeredSystem &system,
                  const JointState &state,
                  const Vector &factor_rates,
                  Drive &drive)
  {
    if (system.opening_water().empty())
      return;
    Vector rates(system.n_bars(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const std::size_t n = elements[k].normal_bar;
        if (state.states[k] == ContactState::open)
          rates[n] = row_product(system.opening_water(), n, factor_rates);
        if (!drive.missing_water.empty())
          rates[n] -= drive.missing_water[n];
      }
    system.add_water(rates, drive.reactions);
  }
} // namespace fuga
