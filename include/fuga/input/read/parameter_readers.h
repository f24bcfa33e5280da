// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_read_parameter_readers_h
#define fuga_input_read_parameter_readers_h

#include <fuga/input/parameters.h>
#include <fuga/input/values/parameter_values.h>
#include <fuga/input/values/sweep_plan.h>

#include <string>
#include <vector>

namespace fuga
{
  /** Read section Boundaries. @throws InputError */
  std::vector<BoundaryCondition>
  read_boundaries(const ParameterValues &values, const unsigned int dimension);

  /** Read section Monitors. @throws InputError */
  std::vector<MonitorDefinition>
  read_monitors(const ParameterValues &values, const unsigned int dimension);

  /** Resolve a path of a parameter file, which is relative to the folder of the file. */
  std::string
  resolve(const std::string &parameter_file, const std::string &path);

  /** Read section Output, for the stages and monitors of the model. @throws InputError */
  void
  read_output(const ParameterValues &values, Parameters &parameters);

  /** Read a file, or a variant of it. Errors are added to @p errors and thrown. */
  Parameters
  read_scan(const ParameterScan &scan, InputErrors &errors);

  /** Read all variants of a sweep. @throws InputError with the errors of all of them. */
  Parameters
  read_sweep(const SweepPlan &plan);

  /**
   * Read section Safety: append the stages that search for a factor of safety and mark the joints
   * whose strength is reduced. @throws InputError
   */
  void
  read_safety(const ParameterValues &values, Parameters &parameters);

  /** Read section Target accuracy. @throws InputError */
  void
  read_accuracy(const ParameterValues &values, Parameters &parameters);

  /** Check for errors that involve several sections. @throws InputError naming both culprits. */
  void
  check_loads_and_supports(const ParameterValues &values, const ModelDefinition &model);
} // namespace fuga

#endif
