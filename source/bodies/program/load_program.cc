// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/program/load_jump.h>
#include <fuga/bodies/program/load_knots.h>
#include <fuga/bodies/program/load_patterns.h>
#include <fuga/bodies/program/load_program.h>
#include <fuga/bodies/straightness.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** The factor of one load in one stage, as function of the stage fraction. */
    template <int dim>
    class StageHistory
    {
    public:
      StageHistory(const ModelDefinition &model,
                   const StageDefinition &stage,
                   const StageDefinition::History &history)
        : load(history.load)
        , expression({history.expression},
                     model.constants,
                     fmt::format("{}: stage '{}', history of load '{}'",
                                 stage.origin,
                                 stage.name,
                                 model.loads[load].name))
      {
      }

      double
      operator()(const double fraction)
      {
        expression.set_time(fraction);
        return expression.value(dealii::Point<dim>(), 0);
      }

      bool
      is_linear()
      {
        return is_straight(*this, 0., 1.);
      }

      const unsigned int load;

    private:
      FieldExpression<dim> expression;
    };

    template <int dim>
    void
    add_stage(const ModelDefinition &model,
              const CondensedSystem<dim> &system,
              const std::size_t number,
              const bool begins_phase,
              const LoadKnots &knots,
              LoadFactors &factors,
              std::vector<std::string> &report)
    {
      const StageDefinition &stage = model.stages[number];
      std::vector<std::unique_ptr<StageHistory<dim>>> histories;
      bool straight = true;
      std::vector<FactorCourse> courses;
      for (const double factor : factors.values.back())
        courses.push_back(factor == 0. ? FactorCourse::none : FactorCourse::constant);
      for (std::size_t h = 0; h < stage.histories.size(); ++h)
        {
          const StageDefinition::History &history = stage.histories[h];
          histories.push_back(std::make_unique<StageHistory<dim>>(model, stage, history));
          const bool linear = histories.back()->is_linear();
          const double last = factors.values.back()[history.load], begin = (*histories.back())(0.);
          straight &= linear;
          courses[history.load] = linear && begin == (*histories.back())(1.)
                                    ? FactorCourse::constant
                                    : FactorCourse::changing;
          if (std::abs(begin - last) <= linear_tolerance * std::max(1., std::abs(begin)))
            continue;
          if (stage.is_dynamic())
            {
              // With inertia a load may come at once: its phase begins with it.
              if (begins_phase)
                factors.values.back()[history.load] = begin;
              continue;
            }
          if (!depends_on_time(model.loads[history.load]))
            throw_jump(model, system, {number, h, last, begin});
          factors.jumps.push_back({number, h, last, begin});
        }
      const std::vector<double> fractions = knots.fractions(number, courses, straight);
      if (fractions.size() > 1)
        report.push_back(
          fmt::format("stage '{}': loads not linear in t, interpolated between {} knots",
                      stage.name,
                      fractions.size() + 1));
      for (const double fraction : fractions)
        {
          Vector values = factors.values.back();
          for (const auto &history : histories)
            values[history->load] = (*history)(fraction);
          factors.corners.push_back(static_cast<double>(number) + fraction);
          factors.values.push_back(std::move(values));
        }
    }

    // The loads that are increased grow from their present values; all others stay constant.
    void
    add_search_for_safety(const ModelDefinition &model,
                          const std::size_t number,
                          LoadFactors &factors)
    {
      const StageDefinition &stage = model.stages[number];
      Vector values                = factors.values.back();
      for (const unsigned int load : stage.increased_loads)
        {
          if (values[load] == 0.)
            throw InputError(
              fmt::format("{}: the load '{}' has the factor 0 at the end of the stages, so that it "
                          "cannot grow in proportion. Name loads that act there.",
                          stage.origin,
                          model.loads[load].name));
          values[load] *= stage.largest_factor;
        }
      factors.corners.push_back(static_cast<double>(number) + 1.);
      factors.values.push_back(std::move(values));
    }

    template <int dim>
    LoadFactors
    evaluate_stages(const ModelDefinition &model,
                    const CondensedSystem<dim> &system,
                    const unsigned int first_stage,
                    const LoadKnots &knots,
                    std::vector<std::string> &report)
    {
      LoadFactors factors;
      factors.values.emplace_back(model.loads.size(), 0.);
      for (std::size_t s = 0; s < model.stages.size(); ++s)
        if (model.stages[s].purpose == StagePurpose::loading)
          {
            add_stage(model, system, s, s == first_stage, knots, factors, report);
            factors.end_of_loading = static_cast<double>(s + 1);
          }
        else
          add_search_for_safety(model, s, factors);
      return factors;
    }

    /** Return a history of these factors, including the stages in which water in joints does not
     * follow their opening. */
    LoadHistory
    history_of(const ModelDefinition &model,
               const std::vector<double> &corners,
               std::vector<Vector> values)
    {
      LoadHistory history(corners, std::move(values));
      for (std::size_t s = 0; s < model.stages.size(); ++s)
        if (model.stages[s].keeps_water)
          history.keep_water_still(static_cast<double>(s), static_cast<double>(s + 1));
      return history;
    }

    template <int dim>
    LoadKnots
    make_knots(const ModelDefinition &model, const CondensedSystem<dim> &system)
    {
      std::vector<std::vector<double>> kinks(model.loads.size());
      for (std::size_t i = 0; i < kinks.size(); ++i)
        if (model.loads[i].kind == LoadKind::uplift)
          kinks[i] = system.uplift(i).levels_of_kinks();
        else if (model.loads[i].kind == LoadKind::depth_pressure)
          kinks[i] = levels_of_kinks(system.discretization(),
                                     system.discretization().boundary_faces(selection(
                                       system.jointed_mesh().label_names, model.loads[i].targets)));
      return {model, std::move(kinks)};
    }
  } // namespace

  template <int dim>
  LoadProgram
  make_load_program(const ModelDefinition &model,
                    const CondensedSystem<dim> &system,
                    const unsigned int first_stage)
  {
    std::vector<std::string> report;
    const LoadFactors factors =
      evaluate_stages(model, system, first_stage, make_knots(model, system), report);
    LoadPatterns<dim> loads(model, system, factors);
    report.insert(report.end(), loads.report.begin(), loads.report.end());

    std::vector<double> levels;
    for (std::size_t s = 0; s < model.stages.size(); ++s)
      for (unsigned int i = 1; i <= model.stages[s].levels; ++i)
        levels.push_back(static_cast<double>(s) + static_cast<double>(i) / model.stages[s].levels);
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (model.loads[i].kind == LoadKind::uplift)
        for (const std::string &line : system.uplift(i).way().report())
          report.push_back(line);
    return {std::move(loads.patterns),
            std::move(loads.sources),
            history_of(model, factors.corners, std::move(loads.values)),
            std::move(levels),
            std::move(report),
            LoadHistory(factors.corners, factors.values),
            factors.end_of_loading};
  }

  template <int dim>
  TemperatureField<dim>
  LoadProgram::temperature(const ModelDefinition &model,
                           const std::vector<std::string> &body_names,
                           const double t) const
  {
    TemperatureField<dim> field;
    const Vector factors = history.factors(t);
    for (std::size_t j = 0; j < sources.size(); ++j)
      if (const LoadDefinition &load = model.loads[sources[j].load];
          load.kind == LoadKind::temperature && factors[j] != 0.)
        field.add(model, body_names, load, sources[j].t, factors[j]);
    return field;
  }

  std::map<std::string, double>
  LoadProgram::factors_by_name(const ModelDefinition &model, const double t) const
  {
    const Vector factors = load_factors.factors(t);
    std::map<std::string, double> result;
    for (std::size_t i = 0; i < factors.size(); ++i)
      result[model.loads[i].name] = factors[i];
    return result;
  }

  template LoadProgram
  make_load_program(const ModelDefinition &, const CondensedSystem<2> &, const unsigned int);
  template TemperatureField<2>
  LoadProgram::temperature(const ModelDefinition &,
                           const std::vector<std::string> &,
                           const double) const;
  template LoadProgram
  make_load_program(const ModelDefinition &, const CondensedSystem<3> &, const unsigned int);
  template TemperatureField<3>
  LoadProgram::temperature(const ModelDefinition &,
                           const std::vector<std::string> &,
                           const double) const;
} // namespace fuga
