// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_loads_load_readers_h
#define fuga_input_loads_load_readers_h

#include <fuga/input/parameters.h>
#include <fuga/input/values/parameter_values.h>

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** Read a level: a number, an expression of the load time or a table. @throws InputError */
  LevelDefinition
  read_level(const ParameterSection &section,
             const AnyEntry &entry,
             const std::map<std::string, double> &constants);

  /** Read the entries of a load that depends on the depth below a level. @throws InputError */
  DepthPressure
  read_depth_pressure(const ParameterSection &section,
                      const std::map<std::string, double> &constants);

  /** Read the entries of water in joints except for those of its level. @throws InputError */
  Uplift
  read_uplift(const ParameterSection &section, const ModelDefinition &model);

  /**
   * Read the coefficients of a seismic load as the force per weight along every axis, in the form
   * of the expressions of a weight. @throws InputError
   */
  std::vector<std::string>
  read_seismic_coefficients(const ParameterSection &section, const unsigned int dimension);

  /** Read section Loads, each load by itself. @throws InputError */
  std::vector<LoadDefinition>
  read_loads(const ParameterValues &values, const ModelDefinition &model);

  /** Read section Stages. @throws InputError */
  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model);

  /** Read when bodies are built and removed, and joints grouted. @throws InputError */
  void
  read_construction(const ParameterValues &values, ModelDefinition &model);

  /**
   * Check the sweep. @throws InputError if variants of a model that is built in stages are
   * requested.
   */
  void
  check_sweep_of_construction(const ParameterValues &values, const Parameters &parameters);
} // namespace fuga

#endif
