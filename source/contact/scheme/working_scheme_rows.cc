// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/scheme/working_scheme.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Share of the bar's own stiffness below which a pivot is a mechanism, not a stiffness. */
    constexpr double smallest_relative_pivot = 1e-13;
    /** Numbers of exchanges after which the matrix is factorised again: this costs little then, and
     * neither the rounding errors of exchanges nor the data that have to be kept of them can grow
     * without bound. */
    constexpr std::size_t exchanges_per_row = 4, most_exchanges = 100;
    /** An inverse of a matrix of unit diagonal with entries G leaves an error of ε G² in the next
     * pivot: a singular matrix may then seem regular, but only with G above 1/√ε = 7e7. */
    constexpr double largest_exchanged = 1e7;

    /** Return the contribution of the layer to the entry of two rows. */
    double
    layer_entry(const SchemeRow &row, const SchemeRow &of)
    {
      double value = 0.;
      for (std::size_t b = 0; b < of.column.size() && row.element == of.element; ++b)
        value += row.stiffness[b] * of.column[b];
      return value;
    }
  } // namespace

  std::vector<SchemeRow>
  WorkingScheme::wanted_rows() const
  {
    std::vector<SchemeRow> wanted;
    for (std::size_t k = 0; k < elements.size(); ++k)
      append_rows_of(
        k, states[k], turning.empty() ? std::nullopt : std::optional(turning[k]), wanted);
    return wanted;
  }

  void
  WorkingScheme::append_rows_of(const std::size_t k,
                                const ContactState in_state,
                                const std::optional<double> &turning_of_slip,
                                std::vector<SchemeRow> &to) const
  {
    Strength strength = strengths[k];
    if (nonlinear)
      strength.friction *= slopes[k];
    append_rows(elements[k],
                k,
                in_state,
                directions[k],
                strength,
                nonlinear ? tangents[k] : LayerTangent(),
                system,
                to,
                turning_of_slip);
  }

  double
  WorkingScheme::entry(const SchemeRow &row, const SchemeRow &of) const
  {
    const ContactElement &of_element = elements[of.element];
    double value                     = 0.;
    for (std::size_t b = 0; b < of_element.n_bars(); ++b)
      if (of.column[b] != 0.)
        value += of.column[b] * forces_in(row, system.stiffness().col(of_element.bar(b)).data());
    return value + layer_entry(row, of);
  }

  // The matrix is assembled column by column: the effect of an unknown on the forces of all bars is
  // read by every row.
  DenseMatrix
  WorkingScheme::active_matrix() const
  {
    const DenseMatrix &W = system.stiffness();
    const std::size_t n  = rows.size();
    DenseMatrix M(n, n);
    Vector forces(W.rows());
    for (std::size_t j = 0; j < n; ++j)
      {
        const ContactElement &element = elements[rows[j].element];
        std::fill(forces.begin(), forces.end(), 0.);
        for (std::size_t b = 0; b < element.n_bars(); ++b)
          if (rows[j].column[b] != 0.)
            view(forces) += rows[j].column[b] * W.col(element.bar(b));
        for (std::size_t i = 0; i < n; ++i)
          M(i, j) = forces_in(rows[i], forces.data()) + layer_entry(rows[i], rows[j]);
      }
    return M;
  }

  bool
  WorkingScheme::rebuild()
  {
    its_work.n_factorisations += rows.empty() ? 0 : 1;
    const bool done = inverse.rebuild(active_matrix());
    stale           = false;
    last_solution   = {};
    factorised_rows = rows;
    capacity        = inverse.capacity();
    exchanges.clear();
    return done;
  }

  void
  WorkingScheme::set_rows(const std::vector<SchemeRow> &new_rows)
  {
    std::fill(position.begin(), position.end(), no_row);
    rows = new_rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
      note_position(i);
  }

  void
  WorkingScheme::note_position(const std::size_t row)
  {
    const std::size_t bar = rows[row].bar;
    position[bar]         = row;
    its_work.n_bars_ever_active += ever_active[bar] ? 0 : 1;
    ever_active[bar] = true;
  }

  void
  WorkingScheme::restore(const SchemeMemory &memory)
  {
    const SchemeMemory wanted          = memory;
    static_cast<SchemeMemory &>(*this) = wanted;
    set_rows(factorised_rows);
    last_solution = {};
    inverse       = {};
    inverse.reserve(capacity);
    if (!singular)
      {
        bool same = rows.empty() || inverse.rebuild(active_matrix());
        exchanges.clear();
        for (const RowExchange &exchange : wanted.exchanges)
          same = same && (exchange.removed == RowExchange::none ? append_row(exchange.appended)
                                                                : remove_row(exchange.removed));
        if (!same)
          throw NumericalFailure("The working scheme of the checkpoint cannot be built again: it "
                                 "was computed with another program or library.");
      }
    set_rows(wanted.rows);
  }

  bool
  WorkingScheme::bring_up_to_date()
  {
    if (!outdated)
      return !singular;
    const std::vector<SchemeRow> wanted = wanted_rows();
    outdated                            = false;
    last_solution                       = {};
    if (!singular && inverse.size() == rows.size())
      take_layer_stiffness(wanted);

    // A few changed rows are cheaper to exchange than to factorise again, unless that is due
    // anyhow.
    std::size_t n_kept = 0;
    for (const SchemeRow &row : wanted)
      n_kept += has_row(row) ? 1 : 0;
    const std::size_t n_changes = (rows.size() - n_kept) + (wanted.size() - n_kept);
    const bool few              = 4 * n_changes <= wanted.size() + 4 &&
                     exchanges.size() <= exchanges_per_row * wanted.size() + most_exchanges;
    if (!singular && inverse.size() == rows.size() && (n_changes == 0 || (few && !stale)) &&
        update_rows(wanted))
      return true;

    set_rows(wanted);
    singular = !rebuild();
    return !singular;
  }

  // The inverse need not follow a nonlinear layer, or a friction that changes, at every step: that
  // of a nearby stiffness serves as the first approximation of a refined solution, the paper's idea
  // on the small system.
  void
  WorkingScheme::take_layer_stiffness(const std::vector<SchemeRow> &wanted)
  {
    const auto follows = [this](const SchemeRow &row) {
      return row.demand == SchemeRow::Demand::layer ||
             row.demand == SchemeRow::Demand::layer_across ||
             (row.demand == SchemeRow::Demand::sliding &&
              (strengths[row.element].share < 1. ||
               elements[row.element].friction.envelope.is_curved()));
    };
    for (const SchemeRow &row : wanted)
      if (follows(row) && position[row.bar] != no_row && !has_row(row))
        {
          SchemeRow &present = rows[position[row.bar]];
          if (present.demand != row.demand)
            continue;
          present = row;
          stale   = true;
        }
  }

  // Equations that depend on each other have a solution only where the loads happen to allow one.
  // Where exchanges cannot decide whether they do, a factorisation has to.
  bool
  WorkingScheme::update_rows(const std::vector<SchemeRow> &wanted)
  {
    std::vector<bool> is_kept(system.n_bars(), false);
    const std::size_t n_exchanges = exchanges.size();
    for (const SchemeRow &row : wanted)
      is_kept[row.bar] = has_row(row);
    for (std::size_t i = rows.size(); i-- > 0;)
      if (!is_kept[rows[i].bar])
        if (!remove_row(i))
          return false;
    for (const SchemeRow &row : wanted)
      if (!is_kept[row.bar])
        if (!append_row(row))
          return false;
    if (exchanges.size() == n_exchanges)
      return true;
    // The diagonal is sufficient, because its largest entry is no less than the mean of the
    // eigenvalues of the inverse.
    double largest = 0.;
    for (std::size_t i = 0; i < rows.size(); ++i)
      largest =
        std::max(largest,
                 std::abs(inverse.entry(i, i)) * std::max(std::abs(entry(rows[i], rows[i])),
                                                          std::pow(system.scale(rows[i].bar), 2)));
    return largest <= largest_exchanged;
  }

  // The last row takes the place of the removed one.
  bool
  WorkingScheme::remove_row(const std::size_t i)
  {
    if (!inverse.remove(i))
      return false;
    position[rows.back().bar] = i;
    position[rows[i].bar]     = no_row;
    rows[i]                   = rows.back();
    rows.pop_back();
    exchanges.push_back({i, {}});
    ++its_work.n_updates;
    return true;
  }

  bool
  WorkingScheme::append_row(const SchemeRow &row)
  {
    Vector column(rows.size()), line(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        column[i] = entry(rows[i], row);
        line[i]   = entry(row, rows[i]);
      }
    const double smallest_pivot =
      smallest_relative_pivot * std::abs(system.stiffness()(row.bar, row.bar));
    if (std::abs(inverse.append(column, line, entry(row, row), smallest_pivot)) <= smallest_pivot)
      return false;
    rows.push_back(row);
    note_position(rows.size() - 1);
    ++its_work.n_updates;
    exchanges.push_back({RowExchange::none, row});
    return true;
  }

  Vector
  WorkingScheme::drives_of_rows(const Drive &drive) const
  {
    Vector result;
    for (const SchemeRow &row : rows)
      result.push_back(row_drive(row, elements[row.element], states[row.element], drive));
    return result;
  }

  Vector
  WorkingScheme::unbalanced_forces(const Vector &rhs, const Vector &force_offset) const
  {
    Vector result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      result[i] = forces_in(rows[i], force_offset.data()) - rhs[i];
    return result;
  }

  double
  WorkingScheme::addition(const SchemeRow &row, const double added_stiffness) const
  {
    const double scale = system.scale(row.bar);
    return added_stiffness * scale * scale;
  }

  DenseMatrix
  WorkingScheme::matrix_with_addition(const double added_stiffness) const
  {
    DenseMatrix M = active_matrix();
    for (std::size_t i = 0; i < rows.size(); ++i)
      M(i, i) += addition(rows[i], added_stiffness);
    return M;
  }

  Vector
  WorkingScheme::residual(const JointState &at)
  {
    bring_up_to_date();
    Vector result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      result[i] = row_residual(rows[i], elements[rows[i].element], at);
    return result;
  }

  // For a layer that has stiffened to C ≫ 1/D the row 1 - C D magnifies the rounding of its jump.
  double
  WorkingScheme::defect_of_layers(const Vector &rhs, const JointRates &rates) const
  {
    double worst = 0.;
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const SchemeRow &row = rows[i];
        double value = -rhs[i], size = 1.;
        for (std::size_t a = 0; a < elements[row.element].n_bars(); ++a)
          {
            const std::size_t bar = elements[row.element].bar(a);
            value += row.own[a] * rates.forces[bar] - row.stiffness[a] * rates.dislocations[bar];
            size = std::max(size, std::abs(row.own[a]));
          }
        worst = std::max(worst, std::abs(value) / (size * system.scale(row.bar)));
      }
    return worst;
  }
} // namespace fuga
