// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_from_contact_h
#define fuga_tests_judges_from_contact_h

#include "judges/judge_problem.h"
#include "sparse.h"

#include <fuga/contact/contact_element.h>
#include <fuga/contact/contact_system.h>
#include <fuga/contact/joint_state.h>

#include <stdexcept>
#include <vector>

namespace fuga::judges
{
  inline Envelope
  envelope_of(const FrictionLaw &law)
  {
    return law.envelope.is_curved() ? Envelope{law.envelope.exponent, law.envelope.pressure}
                                    : Envelope();
  }

  /**
   * The judges' copy of the data that the product works on. Reads numbers only. A nonlinear normal
   * law is taken for law (9) with ζ0 = deformation_limit(); the caller must know that it is.
   */
  inline JudgeProblem
  judge_problem(const ContactSystem &system, const std::vector<ContactElement> &elements)
  {
    JudgeProblem problem;
    problem.S = system.stiffness();
    problem.B = tests::dense(system.jump_operator());
    for (const ContactElement &element : elements)
      {
        JudgeElement copy;
        copy.normal_bar        = element.normal_bar;
        copy.tangential_bar    = element.tangential_bar;
        copy.area              = element.area;
        copy.initial_gap       = element.initial_gap;
        copy.normal_compliance = element.normal_law->initial_compliance();
        if (element.normal_law->kind() == ComplianceKind::nonlinear)
          copy.layer_thickness = element.normal_law->deformation_limit();
        if (element.has_tangential_bar())
          {
            if (element.shear_law->kind() == ComplianceKind::nonlinear)
              throw std::invalid_argument(
                "judge_problem: the judges know linear shear layers only");
            copy.shear_compliance = element.shear_law->initial_compliance();
          }
        copy.friction = element.friction.coefficient;
        copy.envelope = envelope_of(element.friction);
        copy.cohesion = element.friction.cohesion;
        problem.elements.push_back(copy);
      }
    validate(problem);
    return problem;
  }

  /** The slips along the first tangent, the only one in the plane. */
  inline Vector
  judge_slips(const JointState &state)
  {
    Vector slips;
    for (const TangentVector &slip : state.slips)
      slips.push_back(slip[0]);
    return slips;
  }

  /** F a: the load of the judges for the pattern factors @p factors. */
  inline Vector
  judge_load(const ContactSystem &system, const Vector &factors)
  {
    const DenseMatrix &F = system.load_patterns();
    Vector load(F.rows(), 0.);
    for (std::size_t j = 0; j < factors.size(); ++j)
      for (std::size_t i = 0; i < load.size(); ++i)
        load[i] += F(i, j) * factors[j];
    return load;
  }
} // namespace fuga::judges

#endif
