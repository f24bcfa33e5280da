// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/working_scheme.h>

#include <algorithm>

namespace fuga
{
  /** The row that the tangential bar of an element would have in a state; nothing if it had none.
   */
  std::optional<SchemeRow>
  WorkingScheme::tangential_row(const std::size_t k, const ContactState in_state) const
  {
    std::vector<SchemeRow> wanted;
    append_rows(elements[k],
                k,
                in_state,
                strengths[k],
                nonlinear ? tangents[k] : LayerTangent(),
                system,
                wanted);
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
        line[i]   = entry(*row, rows[i].bar);
        column[i] = active ? inverse.entry(i, position[t]) : entry(rows[i], t);
      }
    if (active)
      return dot(line, column);
    return inverse.pivot_of(column, line, entry(*row, t)) / W_tt;
  }

  // Slipping elements are pivoted: their block is that of the inverse. The principal transform of a
  // matrix has a positive definite symmetric part if the matrix has.
  std::optional<bool>
  WorkingScheme::is_monotone(const std::vector<SlipDirection> &slips)
  {
    if (!bring_up_to_date())
      return {};
    const std::size_t n = slips.size();
    DenseMatrix M(n, n);
    std::vector<std::size_t> stuck;
    std::vector<SchemeRow> stuck_rows;
    std::vector<Vector> stuck_responses;
    for (std::size_t j = 0; j < n; ++j)
      {
        const std::size_t k = slips[j].element, t = elements[k].tangential_bar;
        if (is_slipping(states[k]))
          {
            const double *const column = inverse.column_of(position[t]);
            for (std::size_t i = 0; i < n; ++i)
              if (is_slipping(states[slips[i].element]))
                M(i, j) = slips[i].sign * slips[j].sign *
                          column[position[elements[slips[i].element].tangential_bar]];
            continue;
          }
        const std::optional<SchemeRow> row = tangential_row(
          k, slips[j].sign > 0. ? ContactState::slip_forward : ContactState::slip_backward);
        if (position[t] != no_row || !row || strengths[k].dilatancy > 0.)
          return {};
        Vector column(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
          column[i] = entry(rows[i], t);
        stuck.push_back(j);
        stuck_rows.push_back(*row);
        stuck_responses.push_back(inverse.solve(column));
      }
    for (std::size_t b = 0; b < stuck.size(); ++b)
      {
        // Stuck against stuck, and what the slipping ones take over; the mixed blocks are
        // opposite in sign up to what friction adds.
        const std::size_t i = stuck[b];
        Vector line(rows.size());
        for (std::size_t j = 0; j < rows.size(); ++j)
          line[j] = entry(stuck_rows[b], rows[j].bar);
        for (std::size_t c = 0; c < stuck.size(); ++c)
          M(i, stuck[c]) =
            slips[i].sign * slips[stuck[c]].sign *
            (entry(stuck_rows[b], stuck_rows[c].bar) - dot(line, stuck_responses[c]));
        const Vector transferred = inverse.solve_transposed(line);
        for (std::size_t j = 0; j < n; ++j)
          if (is_slipping(states[slips[j].element]))
            {
              const std::size_t at = position[elements[slips[j].element].tangential_bar];
              M(i, j)              = slips[i].sign * slips[j].sign * transferred[at];
              M(j, i)              = -slips[i].sign * slips[j].sign * stuck_responses[b][at];
            }
      }
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = j; i < n; ++i)
        M(i, j) = M(i, j) + M(j, i);
    DenseMatrix nothing(n, 0);
    return solve_positive_definite(M, nothing);
  }
} // namespace fuga
