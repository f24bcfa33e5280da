// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_expression_law_h
#define fuga_bodies_expression_law_h

#include <fuga/laws/nonlinear_law.h>

#include <map>
#include <memory>

namespace fuga
{
  /**
   * A law of the user: muParser expressions of the deformation w for the stress and for its
   * derivative. The energy is the integral of the stress by adaptive Gauss quadrature, as exact as
   * the rounding errors of the expression allow; the inverse is found by Newton's method within a
   * bracket. check_law() checks that the two expressions are consistent.
   */
  class ExpressionLaw : public NonlinearLaw
  {
  public:
    /**
     * @p stress and @p tangent are functions of w and the @p constants; @p limit > 0 [m] is the
     * deformation that no finite stress reaches, infinite if there is none.
     * @throws InputError beginning with @p what if muParser refuses an expression.
     */
    ExpressionLaw(const std::string &stress,
                  const std::string &tangent,
                  const double limit,
                  const std::map<std::string, double> &constants,
                  const std::string &what);

    ~ExpressionLaw() override;

    double
    initial_compliance() const override;
    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    double
    deformation_limit() const override;
    std::string
    description() const override;

  private:
    struct Parsers;

    /**
     * Return whether the tangent at w hardly differs from that at w = 0, so that σ(w) is computed
     * as its integral.
     */
    bool
    is_nearly_linear(const double w) const;

    const std::string stress_text;
    const double limit;
    const std::unique_ptr<const Parsers> parsers;
    /** 1/σ'(0), which is needed at every element and step. */
    const double first_compliance;
  };
} // namespace fuga

#endif
