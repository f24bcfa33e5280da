// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/io/model_echo.h>
#include <fuga/io/model_warnings.h>
#include <fuga/model.h>
#include <fuga/model_check.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    void
    append(std::vector<std::string> &lines, const std::vector<std::string> &more)
    {
      lines.insert(lines.end(), more.begin(), more.end());
    }
  } // namespace

  template <int dim>
  CheckedModel
  check_model(const Parameters &parameters)
  {
    const Model<dim> model(parameters, {}, Condensation::never);
    CheckedModel result;
    const auto add = [&](const CondensedSystem<dim> &bodies, const unsigned int stage) {
      const unsigned int end   = end_of_phase(parameters.model, stage);
      const LoadHistory &loads = model.loads.load_factors;
      append(result.echo, ModelEcho<dim>(parameters, bodies, loads, stage, end).in_full());
      append(result.warnings, model_warnings(parameters, bodies, loads, stage, end));
    };
    add(model.bodies, 0);
    for (const unsigned int stage : first_stages_of_phases(parameters.model))
      if (stage > 0)
        {
          result.echo.push_back(
            fmt::format("Construction at the beginning of stage '{}'", model.stage_names[stage]));
          add(CondensedSystem<dim>(model.mesh,
                                   parameters.model,
                                   std::vector<bool>(parameters.joints.size(), false),
                                   Condensation::never,
                                   stage),
              stage);
        }
    return result;
  }

  template CheckedModel
  check_model<2>(const Parameters &);
  template CheckedModel
  check_model<3>(const Parameters &);
} // namespace fuga
