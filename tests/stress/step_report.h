// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_step_report_h
#define fuga_tests_stress_step_report_h

#include <optional>

namespace fuga::stress
{
  /** What an independent solver says about a step of a path. */
  struct StepReport
  {
    /** How far the end of the step is from satisfying all conditions. */
    double residual = 0.;
    /** How far the solution of the solver is away; nothing if it finds none. */
    std::optional<double> distance;
  };
} // namespace fuga::stress

#endif
