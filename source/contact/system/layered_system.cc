// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/work_counter.h>
#include <fuga/contact/system/layered_system.h>
#include <fuga/contact/system/soft_bars.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    using Indices = std::vector<std::size_t>;

    /** Remove the rounding difference between the two triangles. */
    void
    symmetrise(DenseMatrix &A)
    {
      A = (0.5 * (A + A.transpose())).eval();
    }
  } // namespace

  double
  bar_compliance(const ComplianceLaw &law, const double area)
  {
    return law.reference_compliance() / area;
  }

  LayeredSystem::LayeredSystem(const ContactSystem &system,
                               const std::vector<ContactElement> &elements)
    : bodies(system)
  {
    const work::Scope phase(work::Phase::layered_system);
    std::size_t n_bars = 0;
    for (const ContactElement &element : elements)
      n_bars += element.n_bars();
    compliances.assign(n_bars, 0.);
    curved.assign(n_bars, false);
    for (const ContactElement &element : elements)
      element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
        compliances.at(bar) = bar_compliance(law, element.area);
        curved[bar]         = law.kind() == ComplianceKind::nonlinear;
      });
    if (!system.has_stiffness())
      return; // forces are found in another way
    if (system.jump_operator().is_identity())
      eliminate_in_jumps(system);
    else if (!eliminate_at_corners(system))
      eliminate_with_jump_operator(system);
    symmetrise(W);
    largest = largest_diagonal(W);
    // A jump that nothing resists has no stiffness of its own to be measured by.
    const double smallest = largest > 0. ? 1e-14 * largest : 1.;
    for (std::size_t i = 0; i < compliances.size(); ++i)
      scales.push_back(std::sqrt(std::max(W(i, i), smallest)));
    const bool may_fall = system.jump_operator().is_identity() && system.rigid_motions().size() > 0;
    if (delicate || saddle_factors || may_fall)
      rigid_motions.emplace(system);
    add_imposed_jumps(system);
    if (!delicate || !saddle_factors)
      return;
    refine_responses();
    symmetrise(W);
  }

  void
  LayeredSystem::take_loads(DenseMatrix &&reactions)
  {
    R = std::move(reactions);
    add_imposed_jumps(bodies);
  }

  // δ = B x + E a is d + D p: for the bodies an imposed jump is a dislocation of the opposite sign.
  void
  LayeredSystem::add_imposed_jumps(const ContactSystem &system)
  {
    const DenseMatrix &E = system.imposed_jumps();
    for (Eigen::Index j = 0; j < E.cols(); ++j)
      for (std::size_t bar = 0; bar < n_bars(); ++bar)
        if (E(bar, j) != 0.)
          R.col(j) += E(bar, j) * W.col(bar);
  }

  void
  LayeredSystem::eliminate_in_jumps(const ContactSystem &system)
  {
    W = system.stiffness();
    R = system.load_patterns();
    const double jump_of_others =
      insert_bars(W, R, compliances, {system.rigid_motions(), system.rigid_motion_loads()});
    delicate = has_soft_joint() || has_soft_joint(jump_of_others);
  }

  // With more bars than coordinates (crossing joints, corners, a rigid body on many bars) the
  // saddle point problem [S Bᵀ; B -D] [x; p] = [F a; d] is solved as it stands, scaled to the size
  // of its blocks.
  void
  LayeredSystem::eliminate_with_jump_operator(const ContactSystem &system)
  {
    const DenseMatrix &S    = system.stiffness();
    const SparseOperator &B = system.jump_operator();
    const DenseMatrix &F    = system.load_patterns();
    const std::size_t n_x = S.rows(), n_p = n_bars();

    double scale = largest_diagonal(S);
    if (scale == 0.)
      for (const double D : compliances)
        scale = std::max(scale, D > 0. ? 1. / D : 0.);
    if (scale == 0.)
      scale = 1.;

    DenseMatrix saddle(n_x + n_p, n_x + n_p), rhs(n_x + n_p, n_p + F.cols());
    for (std::size_t j = 0; j < n_x; ++j)
      {
        for (std::size_t i = 0; i < n_x; ++i)
          saddle(i, j) = S(i, j) / scale;
      }
    for (std::size_t i = 0; i < n_p; ++i)
      {
        B.for_each_in_row(i, [&](const std::size_t j, const double factor) {
          saddle(n_x + i, j) = saddle(j, n_x + i) = factor;
        });
        saddle(n_x + i, n_x + i) = -compliances[i] * scale;
        rhs(n_x + i, i)          = 1.;
      }
    for (Eigen::Index j = 0; j < F.cols(); ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        rhs(i, n_p + j) = F(i, j) / scale;

    LuFactors factors(std::move(saddle));
    const double smallest_trusted_condition = 1e-15, harmless_condition = 1e-6;
    if (factors.reciprocal_condition() < smallest_trusted_condition)
      throw_repeated_bars();
    factors.solve(rhs);
    delicate       = factors.reciprocal_condition() < harmless_condition || has_soft_joint();
    saddle_factors = std::move(factors);
    saddle_scale   = scale;

    W = DenseMatrix(n_p, n_p);
    R = DenseMatrix(n_p, F.cols());
    for (std::size_t i = 0; i < n_p; ++i)
      {
        for (std::size_t j = 0; j < n_p; ++j)
          W(i, j) = -rhs(n_x + i, j) * scale;
        for (Eigen::Index j = 0; j < F.cols(); ++j)
          R(i, j) = rhs(n_x + i, n_p + j) * scale;
      }
  }

  // Bars without dislocation are skipped: on most paths these are the majority.
  void
  LayeredSystem::subtract_response(const Vector &dislocations, Vector &forces) const
  {
    for (std::size_t j = 0; j < dislocations.size(); ++j)
      if (dislocations[j] != 0.)
        view(forces) -= dislocations[j] * W.col(j);
  }

  double
  LayeredSystem::scaled_size(const Vector &jumps) const
  {
    double size = 0.;
    for (std::size_t i = 0; i < jumps.size(); ++i)
      size = std::max(size, scales[i] * std::abs(jumps[i]));
    return size;
  }

  void
  LayeredSystem::add_water(const Vector &water, Vector &forces) const
  {
    for (std::size_t j = 0; j < water.size(); ++j)
      if (water[j] != 0.)
        {
          forces[j] += water[j];
          if (compliances[j] != 0.)
            view(forces) -= compliances[j] * water[j] * W.col(j);
        }
  }

  Vector
  LayeredSystem::jumps(const Vector &dislocations, const Vector &forces) const
  {
    Vector jumps = dislocations;
    for (std::size_t i = 0; i < jumps.size(); ++i)
      jumps[i] += compliances[i] * forces[i];
    return jumps;
  }
} // namespace fuga
