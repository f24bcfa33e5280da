// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/blas.h>
#include <fuga/contact/layer_response.h>
#include <fuga/contact/working_scheme.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** A pivot below this share of the bar's own stiffness is a mechanism, not a stiffness. */
    constexpr double smallest_relative_pivot = 1e-13;
    /**
     * Defect of a solution, relative to the forces that drive it, that is accepted at once, and
     * after refinement. A mechanism answers with dislocations so large that their rounding errors
     * alone exceed the second: this, and no pivot, is what tells it from a soft scheme.
     */
    constexpr double good_defect     = 1e-13;
    constexpr double accepted_defect = 1e-8;
  } // namespace

  WorkingScheme::WorkingScheme(const std::vector<ContactElement> &contact_elements,
                               const LayeredSystem &layered_system)
    : elements(contact_elements)
    , system(layered_system)
    , states(contact_elements.size(), ContactState::stick)
    , layer_stiffness(layered_system.n_bars(), 0.)
    , position(layered_system.n_bars(), no_row)
  {
    for (const ContactElement &element : elements)
      nonlinear |= has_nonlinear_closure(element) || has_nonlinear_shear(element);
  }

  void
  WorkingScheme::set_state(const std::size_t element, const ContactState state)
  {
    outdated |= states[element] != state;
    states[element] = state;
  }

  void
  WorkingScheme::linearise(const JointState &at, const LayerStiffness stiffness)
  {
    if (!nonlinear)
      return;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        if (has_nonlinear_closure(element))
          layer_stiffness[element.normal_bar] =
            stiffness == LayerStiffness::initial
              ? element.area / element.normal_law->initial_compliance()
              : normal_stiffness(element, at);
        if (has_nonlinear_shear(element))
          layer_stiffness[element.tangential_bar] =
            stiffness == LayerStiffness::initial
              ? element.area / element.shear_law->initial_compliance()
              : shear_stiffness(element, at, k);
      }
    outdated = true;
  }

  WorkingScheme::Row
  WorkingScheme::layer_row(const std::size_t bar) const
  {
    return {bar, 1. - layer_stiffness[bar] * system.compliance(bar), bar, 0., layer_stiffness[bar]};
  }

  void
  WorkingScheme::add_rows_of(const std::size_t k, std::vector<Row> &wanted) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n = element.normal_bar, t = element.tangential_bar;
    const bool open = states[k] == ContactState::open;

    if (open)
      wanted.push_back({n, 1., n, 0., 0.});
    else if (has_nonlinear_closure(element))
      wanted.push_back(layer_row(n));

    if (!element.has_tangential_bar())
      return;
    if (open)
      wanted.push_back({t, 1., t, 0., 0.});
    else if (is_slipping(states[k]))
      wanted.push_back({t, 1., n, slip_sign(states[k]) * element.friction.coefficient, 0.});
    else if (has_nonlinear_shear(element))
      wanted.push_back(layer_row(t));
  }

  std::vector<WorkingScheme::Row>
  WorkingScheme::wanted_rows() const
  {
    std::vector<Row> wanted;
    for (std::size_t k = 0; k < elements.size(); ++k)
      add_rows_of(k, wanted);
    return wanted;
  }

  double
  WorkingScheme::entry(const Row &row, const std::size_t bar) const
  {
    const DenseMatrix &W = system.stiffness();
    return row.own * W(bar, row.bar) + row.weight * W(bar, row.other) +
           (bar == row.bar ? row.stiffness : 0.);
  }

  DenseMatrix
  WorkingScheme::active_matrix() const
  {
    const std::size_t n = rows.size();
    DenseMatrix M(n, n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        M(i, j) = entry(rows[i], rows[j].bar);
    return M;
  }

  bool
  WorkingScheme::rebuild()
  {
    ++n_factorisations;
    return inverse.rebuild(active_matrix());
  }

  bool
  WorkingScheme::bring_up_to_date()
  {
    if (!outdated)
      return !singular;
    const std::vector<Row> wanted = wanted_rows();
    outdated                      = false;

    // A few changed rows are cheaper to exchange than to factorise anew; a nonlinear layer changes
    // all.
    std::size_t n_kept = 0;
    for (const Row &row : wanted)
      n_kept += has_row(row) ? 1 : 0;
    const std::size_t n_changes = (rows.size() - n_kept) + (wanted.size() - n_kept);
    if (!singular && 4 * n_changes <= wanted.size() + 4 && inverse.size() == rows.size() &&
        update_rows(wanted))
      return true;

    std::fill(position.begin(), position.end(), no_row);
    rows = wanted;
    for (std::size_t i = 0; i < rows.size(); ++i)
      position[rows[i].bar] = i;
    singular = !rebuild();
    return !singular;
  }

  bool
  WorkingScheme::update_rows(const std::vector<Row> &wanted)
  {
    std::vector<bool> is_kept(system.n_bars(), false);
    for (const Row &row : wanted)
      is_kept[row.bar] = has_row(row);
    for (std::size_t i = rows.size(); i-- > 0;)
      if (!is_kept[rows[i].bar])
        {
          if (!inverse.remove(i))
            return false;
          position[rows.back().bar] = i;
          position[rows[i].bar]     = no_row;
          rows[i]                   = rows.back();
          rows.pop_back();
          ++n_updates;
        }
    for (const Row &row : wanted)
      if (!is_kept[row.bar])
        {
          Vector column(rows.size()), line(rows.size());
          for (std::size_t i = 0; i < rows.size(); ++i)
            {
              column[i] = entry(rows[i], row.bar);
              line[i]   = entry(row, rows[i].bar);
            }
          const double smallest_pivot =
            smallest_relative_pivot * std::abs(system.stiffness()(row.bar, row.bar));
          if (std::abs(inverse.append(column, line, entry(row, row.bar), smallest_pivot)) <=
              smallest_pivot)
            return false;
          position[row.bar] = rows.size();
          rows.push_back(row);
          ++n_updates;
        }
    return true;
  }

  // Forces and row defects that belong to the given active dislocations; the largest defect.
  double
  WorkingScheme::apply(const Vector &active,
                       const Vector &force_offset,
                       const Vector &rhs,
                       JointRates &result,
                       Vector &defect) const
  {
    const DenseMatrix &W = system.stiffness();
    result.forces        = force_offset;
    result.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t j = 0; j < rows.size(); ++j)
      {
        blas::axpy(W.n_rows(), -active[j], W.column(rows[j].bar), result.forces.data());
        result.dislocations[rows[j].bar] = active[j];
      }
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const Row &row = rows[i];
        defect[i]      = row.own * result.forces[row.bar] + row.weight * result.forces[row.other] -
                    row.stiffness * active[i] - rhs[i];
      }
    return max_abs(defect);
  }

  std::optional<JointRates>
  WorkingScheme::solve(const Vector &rhs, Vector force_offset)
  {
    if (!bring_up_to_date())
      return {};

    const double driving_force  = std::max(max_abs(force_offset), max_abs(rhs));
    const auto refined_solution = [&](JointRates &result) {
      Vector active(rows.size(), 0.), defect(rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i)
        defect[i] = rows[i].own * force_offset[rows[i].bar] +
                    rows[i].weight * force_offset[rows[i].other] - rhs[i];
      const int max_sweeps = 3;
      double worst         = 0.;
      for (int sweep = 0; sweep == 0 || (sweep < max_sweeps && worst > good_defect * driving_force);
           ++sweep)
        {
          const Vector change = inverse.solve(defect);
          for (std::size_t i = 0; i < active.size(); ++i)
            active[i] += change[i];
          worst = apply(active, force_offset, rhs, result, defect);
        }
      return worst <= accepted_defect * driving_force;
    };

    JointRates result;
    if (refined_solution(result))
      return result;
    singular = !rebuild();
    if (!singular && refined_solution(result))
      return result;
    return {};
  }

  std::optional<JointRates>
  WorkingScheme::rates(const Drive &drive)
  {
    if (!bring_up_to_date())
      return {};
    Vector rhs(rows.size(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (!drive.release.empty() && drive.release[k] != 0. && states[k] != ContactState::stick)
        rhs[position[elements[k].tangential_bar]] =
          is_slipping(states[k]) ? slip_sign(states[k]) * cohesive_strength_rate(drive, k)
                                 : drive.release[k];
    return solve(rhs, drive.reactions);
  }

  std::optional<JointRates>
  WorkingScheme::response(const std::size_t bar)
  {
    if (!bring_up_to_date())
      return {};
    // An active (nonlinear) bar feels the additional dislocation as force of its layer only.
    Vector rhs(rows.size(), 0.), offset(system.n_bars(), 0.);
    if (position[bar] != no_row)
      {
        rhs[position[bar]] = -rows[position[bar]].stiffness;
        return solve(rhs, offset);
      }
    for (std::size_t i = 0; i < offset.size(); ++i)
      offset[i] = -system.stiffness()(i, bar);
    std::optional<JointRates> result = solve(rhs, offset);
    if (result)
      result->dislocations[bar] = 1.;
    return result;
  }

  Vector
  WorkingScheme::residual(const JointState &at)
  {
    bring_up_to_date();
    Vector result(rows.size(), 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
      result[i] = at.forces[rows[i].bar] + rows[i].weight * at.forces[rows[i].other];
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const bool open               = states[k] == ContactState::open;
        if (!open && has_nonlinear_closure(element))
          result[position[element.normal_bar]] -= normal_force(element, at);
        if (!element.has_tangential_bar() || position[element.tangential_bar] == no_row)
          continue;
        double &defect = result[position[element.tangential_bar]];
        if (open)
          defect -= at.unreleased_shear[k];
        else if (is_slipping(states[k]))
          defect -= slip_sign(states[k]) * cohesive_strength(element, at, k);
        else
          defect -= shear_force(element, at, k);
      }
    return result;
  }

  std::optional<JointRates>
  WorkingScheme::correction(const Vector &defects)
  {
    Vector rhs(defects.size());
    std::transform(defects.begin(), defects.end(), rhs.begin(), [](const double r) { return -r; });
    return solve(rhs, Vector(system.n_bars(), 0.));
  }

  // Inverse iteration on the matrix, shifted by rounding: three steps suffice for a
  // null vector that is only to be shown.
  JointRates
  WorkingScheme::mechanism() const
  {
    DenseMatrix M        = active_matrix();
    const double epsilon = 1e-14;
    for (std::size_t i = 0; i < rows.size(); ++i)
      M(i, i) += epsilon * system.stiffness()(rows[i].bar, rows[i].bar);
    const LuFactors factors(std::move(M));
    Vector x(rows.size(), 1.);
    for (int step = 0; step < 3 && factors.reciprocal_condition() > 0.; ++step)
      {
        factors.solve(x);
        const double largest = max_abs(x);
        for (double &value : x)
          value /= largest;
      }
    JointRates result;
    result.forces.assign(system.n_bars(), 0.);
    result.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.dislocations[rows[i].bar] = x[i];
    return result;
  }
} // namespace fuga
