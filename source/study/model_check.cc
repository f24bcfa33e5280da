// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/output/warnings/dynamic_data.h>
#include <fuga/output/warnings/model_echo.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/run/model/model.h>
#include <fuga/study/model_check.h>
#include <fuga/study/sweep.h>

#include <algorithm>
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

    void
    append_new(std::vector<std::string> &lines, const std::vector<std::string> &more)
    {
      for (const std::string &line : more)
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
          lines.push_back(line);
    }

    template <int dim>
    CheckedModel
    check_phases(const Parameters &parameters, const Model<dim> &model)
    {
      CheckedModel result;
      const auto add = [&](const CondensedSystem<dim> &bodies, const unsigned int stage) {
        const unsigned int end   = end_of_phase(parameters.model, stage);
        const LoadHistory &loads = model.loads.load_factors;
        append(result.echo, ModelEcho<dim>(parameters, bodies, loads, stage, end).in_full());
        append(result.warnings, model_warnings(parameters, bodies, loads, stage, end));
      };
      add(model.bodies, 0);
      append(result.echo, ground_motion_echo(parameters));
      for (const unsigned int stage : first_stages_of_phases(parameters.model))
        if (stage > 0)
          {
            result.echo.push_back(
              fmt::format("{} at the beginning of stage '{}'",
                          changes_construction(parameters.model, stage) ? "Construction" : "Model",
                          model.stage_names[stage]));
            add(CondensedSystem<dim>(model.mesh,
                                     parameters.model,
                                     std::vector<bool>(parameters.joints.size(), false),
                                     Condensation::never,
                                     stage),
                stage);
          }
      return result;
    }

    /** Check every condensation, and the joints of every variant on it. */
    template <int dim>
    CheckedModel
    check_sweep(const Parameters &sweep)
    {
      CheckedModel result;
      for (std::size_t c = 0; c < sweep.condensations.size(); ++c)
        {
          const auto model       = checked_model<dim>(sweep, c, Condensation::never);
          const CheckedModel one = check_phases(model->parameters, *model);
          if (c == 0)
            result.echo = one.echo;
          append_new(result.warnings, one.warnings);
          for (const Variant &variant : sweep.variants)
            if (variant.condensation == c)
              append_new(result.warnings,
                         implausible_dynamics(parameters_of(variant, model->parameters)));
        }
      result.echo.push_back(fmt::format(
        "Sweep: {} variants; the bodies are condensed {}. What is said above is of the "
        "first variant.",
        sweep.variants.size(),
        sweep.condensations.size() == 1 ? "once"
                                        : fmt::format("{} times", sweep.condensations.size())));
      return result;
    }
  } // namespace

  template <int dim>
  CheckedModel
  check_model(const Parameters &parameters)
  {
    return parameters.of_sweep
             ? check_sweep<dim>(parameters)
             : check_phases(parameters, Model<dim>(parameters, {}, Condensation::never));
  }

  template CheckedModel
  check_model<2>(const Parameters &);
  template CheckedModel
  check_model<3>(const Parameters &);
} // namespace fuga
