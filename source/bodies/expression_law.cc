// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/expression_law.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  struct ExpressionLaw::Parsers
  {
    dealii::FunctionParser<1> stress{1};
    dealii::FunctionParser<1> tangent{1};

    Parsers(const std::string &stress_expression,
            const std::string &tangent_expression,
            std::map<std::string, double> constants,
            const std::string &what)
    {
      constants.emplace("pi", dealii::numbers::PI);
      try
        {
          stress.initialize("w", stress_expression, constants);
          tangent.initialize("w", tangent_expression, constants);
          // Syntax errors only appear at the first evaluation.
          stress.value(dealii::Point<1>(0.));
          tangent.value(dealii::Point<1>(0.));
        }
      catch (const dealii::ExceptionBase &error)
        {
          throw InputError(fmt::format("{}: {}", what, error.what()));
        }
    }
  };

  ExpressionLaw::ExpressionLaw(const std::string &stress_expression,
                               const std::string &tangent_expression,
                               const double deformation_limit,
                               const std::map<std::string, double> &constants,
                               const std::string &what)
    : stress_text(stress_expression)
    , limit(deformation_limit)
    , parsers(std::make_unique<Parsers>(stress_expression, tangent_expression, constants, what))
    , first_compliance(1. / tangent(0.))
  {
  }

  ExpressionLaw::~ExpressionLaw() = default;

  double
  ExpressionLaw::initial_compliance() const
  {
    return first_compliance;
  }

  bool
  ExpressionLaw::is_nearly_linear(const double w) const
  {
    constexpr double small_change = 1e-2;
    return w > 0. && std::abs(tangent(w) * first_compliance - 1.) <= small_change;
  }

  // Near w = 0 the terms of an expression cancel, as in √(1 + w) - 1, and the rest is a staircase
  // on which the Newton method of a path finds no equilibrium. The tangent need not vanish there,
  // so that its integral keeps all digits; with x = w s³ it is smooth for roots as well.
  double
  ExpressionLaw::stress(const double w) const
  {
    if (is_nearly_linear(w))
      return boost::math::quadrature::gauss<double, 7>::integrate(
        [this, w](const double s) { return 3. * w * s * s * tangent(w * s * s * s); }, 0., 1.);
    return parsers->stress.value(dealii::Point<1>(w));
  }

  double
  ExpressionLaw::tangent(const double w) const
  {
    return parsers->tangent.value(dealii::Point<1>(w));
  }

  namespace
  {
    using Rule = boost::math::quadrature::gauss<double, 15>;

    /** An interval, with one application of the rule to each half. */
    struct Part
    {
      double begin, end, left, right;
      /** Difference between one application of the rule to both halves and one to the whole. */
      double defect;

      double
      middle() const
      {
        return 0.5 * (begin + end);
      }

      double
      value() const
      {
        return left + right;
      }
    };

    template <typename Function>
    Part
    halved(const Function &f, const double begin, const double end, const double whole)
    {
      const double middle = 0.5 * (begin + end);
      const double left   = Rule::integrate(f, begin, middle),
                   right  = Rule::integrate(f, middle, end);
      return {begin, end, left, right, std::abs(left + right - whole)};
    }

    /**
     * Return ∫f over [0, 1], where the part with the largest defect is halved first. An expression
     * is known only up to its rounding errors, and where its terms cancel these are large. Where
     * halving does not reduce small defects any more, they are noise, and more parts would not
     * help.
     */
    template <typename Function>
    double
    adaptive_integral(const Function &f)
    {
      constexpr double tolerance       = 1e-14;
      constexpr double largest_noise   = 1e-6;
      constexpr int most_noisy_parts   = 4;
      constexpr std::size_t most_parts = 200;
      std::vector<Part> parts          = {halved(f, 0., 1., Rule::integrate(f, 0., 1.))};
      double sum = parts[0].value(), defect = parts[0].defect;
      for (int n_noisy = 0; defect > tolerance * std::abs(sum) && n_noisy < most_noisy_parts &&
                            parts.size() < most_parts;)
        {
          const auto worst =
            std::max_element(parts.begin(), parts.end(), [](const Part &a, const Part &b) {
              return a.defect < b.defect;
            });
          const Part old   = *worst;
          *worst           = halved(f, old.begin, old.middle(), old.left);
          const Part right = halved(f, old.middle(), old.end, old.right);
          if (worst->defect + right.defect > 0.5 * old.defect &&
              old.defect <= largest_noise * std::abs(sum))
            ++n_noisy;
          parts.push_back(right);
          sum = defect = 0.;
          for (const Part &part : parts)
            {
              sum += part.value();
              defect += part.defect;
            }
        }
      return sum;
    }
  } // namespace

  // Where the stress is an integral of the tangent, the inner one of the two integrals over x is
  // evaluated at once (Cauchy's formula for repeated integration): ∫ (w - x) σ'(x) dx. The
  // substitution x = w s³ makes a root of x at x = 0, as in law (9), smooth.
  double
  ExpressionLaw::energy(const double w) const
  {
    if (w <= 0.)
      return 0.;
    if (is_nearly_linear(w))
      return Rule::integrate(
        [this, w](const double s) {
          const double s3 = s * s * s;
          return 3. * w * w * s * s * (1. - s3) * tangent(w * s3);
        },
        0.,
        1.);
    return adaptive_integral(
      [this, w](const double s) { return 3. * w * s * s * stress(w * s * s * s); });
  }

  // The bracket is doubled, or extended by half of the remaining distance to the limit, until the
  // stress is exceeded.
  double
  ExpressionLaw::deformation(const double sigma) const
  {
    const int max_doublings = 1000;
    if (sigma <= 0.)
      return 0.;
    double lower = 0., upper = std::min(sigma * first_compliance, 0.5 * limit);
    for (int i = 0; i < max_doublings && stress(upper) < sigma; ++i)
      {
        lower = upper;
        upper = std::min(2. * upper, 0.5 * (upper + limit));
      }
    return deformation_between(sigma, lower, upper);
  }

  double
  ExpressionLaw::deformation_limit() const
  {
    return limit;
  }

  std::string
  ExpressionLaw::description() const
  {
    return fmt::format("stress = {}", stress_text);
  }
} // namespace fuga
