// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_model_check_h
#define fuga_study_model_check_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /** The result of a check of the input. */
  struct CheckedModel
  {
    /** Totals of the model for every phase of construction, see ModelEcho. */
    std::vector<std::string> echo;
    /** The model_warnings() of all phases. */
    std::vector<std::string> warnings;
  };

  /**
   * Read the mesh and check the whole input, of all phases of construction, without computing
   * anything. @throws InputError
   */
  template <int dim>
  CheckedModel
  check_model(const Parameters &parameters);
} // namespace fuga

#endif
