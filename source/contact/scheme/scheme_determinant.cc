// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/scheme/working_scheme.h>

#include <algorithm>

namespace fuga
{
  /** The row is that which the tangential bar of an element would have in a state; there is none if
   * it had none. */
  std::optional<SchemeRow>
  WorkingScheme::tangential_row(const std::size_t k, const ContactState in_state) const
  {
    std::vector<SchemeRow> wanted;
    append_rows_of(k, in_state, {}, wanted);
    for (const SchemeRow &row : wanted)
      if (row.bar == elements[k].tangential_bar)
        return row;
    return {};
  }

  int
  WorkingScheme::determinant_sign()
  {
    return bring_up_to_date() ? inverse.determinant_sign() : 0;
  }

  double
  WorkingScheme::determinant_ratio(const std::size_t k, const ContactState to)
  {
    if (!bring_up_to_date())
      return 0.;
    const std::size_t t                = elements[k].tangential_bar;
    const std::optional<SchemeRow> row = tangential_row(k, to);
    const bool active                  = position[t] != no_row;
    const double W_tt                  = system.stiffness()(t, t);
    if (!row)
      return active ? inverse.entry(position[t], position[t]) * W_tt : 1.;
    Vector line(rows.size()), column(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        line[i]   = entry(*row, rows[i]);
        column[i] = active ? inverse.entry(i, position[t]) : entry(rows[i], *row);
      }
    if (active)
      return dot(line, column);
    return inverse.pivot_of(column, line, entry(*row, *row)) / W_tt;
  }

  // Slipping elements are pivoted: their block is that of the inverse. The principal transform of a
  // matrix has a positive definite symmetric part if the matrix has one.
  std::optional<bool>
  WorkingScheme::is_monotone(const std::vector<SlipDirection> &slips)
  {
    if (!bring_up_to_date() || stale)
      return {};
    const std::size_t n = slips.size();
    std::vector<std::size_t> active(n), stuck;
    for (std::size_t j = 0; j < n; ++j)
      {
        active[j] = position[elements[slips[j].element].tangential_bar];
        if (is_slipping(states[slips[j].element]))
          continue;
        if (active[j] != no_row || strengths[slips[j].element].dilatancy > 0.)
          return {};
        stuck.push_back(j);
      }
    // Only the lower triangle of the symmetric part is filled.
    DenseMatrix M(n, n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = j; i < n; ++i)
        if (active[i] != no_row && active[j] != no_row)
          M(i, j) = slips[i].sign * slips[j].sign *
                    (inverse.entry(active[i], active[j]) + inverse.entry(active[j], active[i]));
    if (!stuck.empty())
      add_stuck_slips(slips, active, stuck, M);
    DenseMatrix nothing(n, 0);
    return solve_positive_definite(M, nothing);
  }

  void
  WorkingScheme::add_stuck_slips(const std::vector<SlipDirection> &slips,
                                 const std::vector<std::size_t> &active,
                                 const std::vector<std::size_t> &stuck,
                                 DenseMatrix &M) const
  {
    std::vector<SchemeRow> stuck_rows;
    std::vector<Vector> responses;
    for (const std::size_t j : stuck)
      {
        stuck_rows.push_back(*tangential_row(slips[j].element,
                                             slips[j].sign > 0. ? ContactState::slip_forward
                                                                : ContactState::slip_backward));
        Vector column(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
          column[i] = entry(rows[i], stuck_rows.back());
        responses.push_back(inverse.solve(column));
      }
    const auto add = [&](const std::size_t i, const std::size_t j, const double value) {
      M(std::max(i, j), std::min(i, j)) += slips[i].sign * slips[j].sign * value;
    };
    for (std::size_t b = 0; b < stuck.size(); ++b)
      {
        const std::size_t i  = stuck[b];
        const SchemeRow &row = stuck_rows[b];
        Vector line(rows.size());
        for (std::size_t j = 0; j < rows.size(); ++j)
          line[j] = entry(row, rows[j]);
        for (std::size_t c = 0; c < stuck.size(); ++c)
          {
            const double value = entry(row, stuck_rows[c]) - dot(line, responses[c]);
            add(i, stuck[c], b == c ? 2. * value : value);
          }
        const Vector transferred = inverse.solve_transposed(line);
        for (std::size_t j = 0; j < slips.size(); ++j)
          if (active[j] != no_row)
            add(i, j, transferred[active[j]] - responses[b][active[j]]);
      }
  }
} // namespace fuga
