// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_run_outcome_h
#define fuga_run_journal_run_outcome_h

#include <fuga/output/tables/summary.h>

namespace fuga
{
  /** Exit codes of the program. */
  enum class ExitCode
  {
    done                 = 0,
    input_error          = 1,
    numerical_failure    = 2,
    loss_of_equilibrium  = 3,
    certificate_violated = 4,
    not_written          = 5
  };

  /** The outcome of a run. */
  struct RunOutcome
  {
    PathResult path;
    std::string verdict;
    ExitCode code = ExitCode::done;
    /** Reason of a numerical failure, or the explanation of a certificate above its bound. */
    std::string message;
    std::vector<SafetyFactor> safety;
    LimitProof proof;
  };
} // namespace fuga

#endif
