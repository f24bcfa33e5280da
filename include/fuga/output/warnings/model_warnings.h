// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_model_warnings_h
#define fuga_output_warnings_model_warnings_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/contact/load_history.h>
#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Return all warnings that are known before anything is computed: implausible_data(),
   * implausible_dynamics(), ImplausibleLoads, excessive output. They concern the phase of
   * construction from @p first_stage to the stage before @p end_stage, in which @p system has the
   * bodies; those about the whole run are given in the first phase. @p load_factors are
   * LoadProgram::load_factors.
   */
  template <int dim>
  std::vector<std::string>
  model_warnings(const Parameters &parameters,
                 const CondensedSystem<dim> &system,
                 const LoadHistory &load_factors,
                 const unsigned int first_stage,
                 const unsigned int end_stage);
} // namespace fuga

#endif
