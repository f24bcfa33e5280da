// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/law_check.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    using Problem = std::optional<LawProblem>;

    /** First deformation that is tested, and ratio of two neighbouring ones, far from a limit. */
    constexpr double first_share = 1e-6;
    constexpr double growth      = 1.2;
    /** Largest number of deformations, because a law may never reach the largest stress. */
    constexpr int max_samples = 400;
    /** Remaining share of the way to a limit that is tested last. */
    constexpr double closest_to_limit = 1e-6;
    /** Step of the difference quotient that the tangent is compared with, relative to the
     * deformation. */
    constexpr double difference_step     = 1e-5;
    constexpr double tangent_tolerance   = 1e-4;
    constexpr double identity_tolerance  = 1e-8;
    constexpr double energy_tolerance    = 1e-3;
    constexpr double increment_tolerance = 0.02;

    bool
    is_close(const double a, const double b, const double tolerance)
    {
      return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
    }

    /** Return ∫ f dw by Gauss's rule with five points. */
    template <typename Function>
    double
    integral(const Function &f, const double a, const double b)
    {
      const double x[] = {0., 0.5384693101056831, 0.9061798459386640};
      const double g[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
      const double m = 0.5 * (a + b), h = 0.5 * (b - a);
      double sum = g[0] * f(m);
      for (int i = 1; i < 3; ++i)
        sum += g[i] * (f(m - h * x[i]) + f(m + h * x[i]));
      return h * sum;
    }

    /** Return the size of the relevant deformations. */
    double
    scale_of(const ComplianceLaw &law, const double stress)
    {
      return std::isfinite(law.deformation_limit()) ? law.deformation_limit()
             : law.deformation_scale() > 0.         ? law.deformation_scale()
                                                    : law.initial_compliance() * stress;
    }

    std::vector<double>
    samples(const ComplianceLaw &law, const double largest_stress)
    {
      const double limit = law.deformation_limit();
      const double scale = scale_of(law, largest_stress);
      std::vector<double> result;
      double w = first_share * scale;
      for (int i = 0; i < max_samples; ++i)
        {
          result.push_back(w);
          if (limit - w < closest_to_limit * limit ||
              (!std::isfinite(limit) && w > growth * law.deformation_scale() &&
               !(law.stress(w) < largest_stress)))
            break;
          w = std::min(growth * w, 0.5 * (w + limit));
        }
      for (const double knot : law.knots())
        result.push_back(knot);
      std::sort(result.begin(), result.end());
      return result;
    }

    Problem
    check_origin(const ComplianceLaw &law)
    {
      const double tangent = law.tangent(0.);
      if (!(law.stress(0.) == 0.))
        return {{0., fmt::format("the stress without deformation is {:g}, not 0", law.stress(0.))}};
      if (!(tangent > 0. && std::isfinite(tangent)))
        return {{0., fmt::format("the tangent is {:g}; it must be positive and finite", tangent)}};
      if (!is_close(law.initial_compliance() * tangent, 1., identity_tolerance))
        return {{0., "the initial compliance is not the inverse of the tangent"}};
      if (law.energy(0.) != 0. || law.deformation(0.) != 0.)
        return {{0., "energy and deformation without stress are not 0"}};
      return {};
    }

    Problem
    check_tangent(const ComplianceLaw &law, const double w)
    {
      const double tangent = law.tangent(w);
      if (!(tangent > 0. && std::isfinite(tangent)))
        return {{w, fmt::format("the tangent is {:g}; it must be positive and finite", tangent)}};
      const double h   = difference_step * std::min(w, law.deformation_limit() - w);
      const auto knots = law.knots();
      if (std::any_of(
            knots.begin(), knots.end(), [&](const double knot) { return std::abs(w - knot) <= h; }))
        return {};
      const double slope = (law.stress(w + h) - law.stress(w - h)) / (2. * h);
      if (!is_close(tangent, slope, tangent_tolerance))
        return {{w,
                 fmt::format("the tangent is {:.6g} but the stress grows by {:.6g} per deformation",
                             tangent,
                             slope)}};
      return {};
    }

    Problem
    check_point(const ComplianceLaw &law, const double w)
    {
      const double stress = law.stress(w);
      if (!(stress > 0. && std::isfinite(stress)))
        return {{w, fmt::format("the stress is {:g}; it must be positive and finite", stress)}};
      if (const Problem problem = check_tangent(law, w))
        return problem;
      if (!is_close(law.secant(w) * w, stress, identity_tolerance))
        return {{w, "the secant is not stress/deformation"}};
      // Close to a limit the stress determines the deformation better than the deformation
      // determines the stress.
      const double back = law.deformation(stress);
      if (!is_close(law.stress(back), stress, identity_tolerance) &&
          !is_close(back, w, identity_tolerance))
        return {
          {w, fmt::format("the deformation of the stress {:g} comes out as {:g}", stress, back)}};
      return {};
    }

    Problem
    check_interval(const ComplianceLaw &law, const double a, const double b)
    {
      if (!(a < b))
        return {};
      const double increment = law.stress(b) - law.stress(a);
      const double tangents  = integral([&](const double w) { return law.tangent(w); }, a, b);
      if (!(increment > 0.))
        return {
          {b, fmt::format("the stress falls, from {:g} to {:g}", law.stress(a), law.stress(b))}};
      if (!is_close(increment, tangents, increment_tolerance))
        return {{b,
                 fmt::format("since {:g} the stress grows by {:.6g} but the tangent promises "
                             "{:.6g}: the stress jumps, or the tangent is not its derivative",
                             a,
                             increment,
                             tangents)}};
      const double work = integral([&](const double w) { return law.stress(w); }, a, b);
      if (!is_close(law.energy(b) - law.energy(a), work, energy_tolerance))
        return {{b,
                 fmt::format("since {:g} the energy grows by {:.6g}, the work is {:.6g}",
                             a,
                             law.energy(b) - law.energy(a),
                             work)}};
      return {};
    }
  } // namespace

  Problem
  check_law(const ComplianceLaw &law, const double largest_stress)
  {
    if (law.kind() == ComplianceKind::rigid)
      return {};
    if (const Problem problem = check_origin(law))
      return problem;
    const std::vector<double> ws = samples(law, largest_stress);
    for (std::size_t i = 0; i < ws.size(); ++i)
      {
        if (const Problem problem = check_point(law, ws[i]))
          return problem;
        if (i > 0)
          if (const Problem problem = check_interval(law, ws[i - 1], ws[i]))
            return problem;
      }
    const double limit = law.deformation_limit();
    const double last  = (1. - 1e-9) * limit;
    if (std::isfinite(limit) && !(law.stress(last) >= largest_stress))
      return {{last,
               fmt::format("the stress just before the limit is {:g}, not even {:g}; it must grow "
                           "without bound there",
                           law.stress(last),
                           largest_stress)}};
    return {};
  }

  double
  range_of_interest(const ComplianceLaw &law, const double typical_stress)
  {
    const double share_of_limit = 0.9;
    if (std::isfinite(law.deformation_limit()))
      return share_of_limit * law.deformation_limit();
    return law.deformation_scale() > 0. ? growth * law.deformation_scale()
                                        : law.deformation(typical_stress);
  }
} // namespace fuga
