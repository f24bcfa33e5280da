// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_confirm_motion_h
#define fuga_tests_stress_confirm_motion_h

#include "stress/confirm.h"

namespace fuga::stress
{
  /**
   * Follows a scene with motions again and puts pieces of its steps of time before the independent
   * solvers, for @p seconds: a step is the static problem with another stiffness and with the jumps
   * that there are when it begins. What the stiffness and the loads of a step are worth is seen
   * from the ledger of energies, not here. @p verdict: that of the first time; a numerical failure
   * is followed to its end, whose law may be exhausted.
   */
  template <int dim>
  Confirmation
  confirm_motion(const Parameters &parameters, const std::string &verdict, const double seconds);
} // namespace fuga::stress

#endif
