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
  /** A level: a number, an expression of the load time or a table. @throws InputError */
  LevelDefinition
  read_level(const ParameterSection &section,
             const AnyEntry &entry,
             const std::map<std::string, double> &constants);

  /** The entries of a load that depends on the depth below a level. @throws InputError */
  DepthPressure
  read_depth_pressure(const ParameterSection &section,
                      const std::map<std::string, double> &constants);

  /** The entries of water in joints but for those of its level. @throws InputError */
  Uplift
  read_uplift(const ParameterSection &section, const ModelDefinition &model);

  /** The coefficients of a seismic load as the force per weight along every axis, expressions of a
   * weight. @throws InputError */
  std::vector<std::string>
  read_seismic_coefficients(const ParameterSection &section, const unsigned int dimension);

  /** Section Loads, each load for itself. @throws InputError */
  std::vector<LoadDefinition>
  read_loads(const ParameterValues &values, const ModelDefinition &model);

  /** Section Stages. @throws InputError */
  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model);

  /** When bodies are built and removed, and joints grouted. @throws InputError */
  void
  read_construction(const ParameterValues &values, ModelDefinition &model);

  /** @throws InputError if variants are to be run of something that is built in stages. */
  void
  check_sweep_of_construction(const ParameterValues &values, const Parameters &parameters);
} // namespace fuga

#endif
