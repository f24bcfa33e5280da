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
          // Syntax errors come at the first evaluation only.
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

  double
  ExpressionLaw::stress(const double w) const
  {
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

    /** Corrects @p whole, one application of the rule to [a, b], until halving no longer changes it. */
    template <typename Function>
    double
    refined(const Function &f,
            const double a,
            const double b,
            const double whole,
            const double scale,
            const int depth)
    {
      const double tolerance = 1e-14;
      const double middle    = 0.5 * (a + b);
      const double left = Rule::integrate(f, a, middle), right = Rule::integrate(f, middle, b);
      if (depth == 0 || std::abs(left + right - whole) <= tolerance * scale)
        return left + right;
      return refined(f, a, middle, left, scale, depth - 1) +
             refined(f, middle, b, right, scale, depth - 1);
    }
  } // namespace

  double
  ExpressionLaw::energy(const double w) const
  {
    const int max_halvings = 40;
    if (w <= 0.)
      return 0.;
    const auto f       = [this](const double x) { return stress(x); };
    const double whole = Rule::integrate(f, 0., w);
    return refined(f, 0., w, whole, whole, max_halvings);
  }

  // A bracket: doubled, or half of the rest of the way to the limit, until the stress is passed.
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
