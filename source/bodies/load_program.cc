// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/load_program.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Deviation from a straight line that is rounding, relative to the size of the history. */
    constexpr double linear_tolerance = 1e-12;

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

      // Irregular fractions, so that no usual periodic or piecewise history looks straight at all
      // of them.
      bool
      is_linear()
      {
        const double begin = (*this)(0.), end = (*this)(1.);
        for (const double s : {0.0719, 0.1931, 0.3137, 0.4391, 0.5, 0.5813, 0.6877, 0.8123, 0.9377})
          if (std::abs((*this)(s) - (1. - s) * begin - s * end) >
              linear_tolerance * std::max(std::abs(begin), std::abs(end)))
            return false;
        return true;
      }

      const unsigned int load;

    private:
      FieldExpression<dim> expression;
    };

    /** Factor of every load at the corners of all stages. */
    struct Factors
    {
      std::vector<double> corners = {0.};
      std::vector<Vector> values;
    };

    void
    check_continuity(const ModelDefinition &model,
                     const StageDefinition &stage,
                     const StageDefinition::History &history,
                     const double last,
                     const double begin)
    {
      if (std::abs(begin - last) <= linear_tolerance * std::max(1., std::abs(begin)) ||
          depends_on_time(model.loads[history.load]))
        return;
      throw InputError(fmt::format(
        "{}: stage '{}': the load '{}' jumps from the factor {:g} to {:g} at the beginning of "
        "the stage (history '{}' at t = 0). A load must grow from where it is, so that no "
        "event is passed over: begin the history with {:g}; t is the fraction of the stage "
        "and goes from 0 to 1.",
        stage.origin,
        stage.name,
        model.loads[history.load].name,
        last,
        begin,
        history.expression,
        last));
    }

    template <int dim>
    void
    add_stage(const ModelDefinition &model,
              const std::size_t number,
              Factors &factors,
              std::vector<std::string> &report)
    {
      const StageDefinition &stage = model.stages[number];
      std::vector<std::unique_ptr<StageHistory<dim>>> histories;
      bool straight = true;
      for (const StageDefinition::History &history : stage.histories)
        {
          histories.push_back(std::make_unique<StageHistory<dim>>(model, stage, history));
          check_continuity(
            model, stage, history, factors.values.back()[history.load], (*histories.back())(0.));
          straight &= histories.back()->is_linear();
        }
      for (const LoadDefinition &load : model.loads)
        straight &= !depends_on_time(load);

      const unsigned int n_pieces = straight ? 1 : model.load_knots;
      if (!straight)
        report.push_back(
          fmt::format("stage '{}': loads not linear in t, interpolated between {} knots",
                      stage.name,
                      n_pieces + 1));
      for (unsigned int i = 1; i <= n_pieces; ++i)
        {
          const double fraction = static_cast<double>(i) / n_pieces;
          Vector values         = factors.values.back();
          for (const auto &history : histories)
            values[history->load] = (*history)(fraction);
          factors.corners.push_back(static_cast<double>(number) + fraction);
          factors.values.push_back(std::move(values));
        }
    }

    void
    scale(LoadPattern &pattern, const double factor)
    {
      for (double &value : pattern.forces)
        value *= factor;
      for (double &value : pattern.prescribed)
        value *= factor;
    }
  } // namespace

  template <int dim>
  Factors
  evaluate_stages(const ModelDefinition &model, std::vector<std::string> &report)
  {
    Factors factors;
    factors.values.emplace_back(model.loads.size(), 0.);
    for (std::size_t s = 0; s < model.stages.size(); ++s)
      add_stage<dim>(model, s, factors, report);
    return factors;
  }

  template <int dim>
  LoadHistory
  make_load_history(const ModelDefinition &model)
  {
    std::vector<std::string> unused;
    const Factors factors = evaluate_stages<dim>(model, unused);
    return {factors.corners, factors.values};
  }

  template <int dim>
  LoadProgram
  make_load_program(const ModelDefinition &model, const CondensedSystem<dim> &system)
  {
    std::vector<std::string> report;
    const Factors factors       = evaluate_stages<dim>(model, report);
    const std::size_t n_corners = factors.corners.size();

    // A load fixed in space is one pattern. One that changes with time is one pattern per corner,
    // with a hat function as history.
    std::vector<LoadPattern> patterns;
    std::vector<Vector> values(n_corners);
    for (unsigned int i = 0; i < model.loads.size(); ++i)
      if (!depends_on_time(model.loads[i]))
        {
          patterns.push_back(system.assemble_load(i, 0.));
          for (std::size_t c = 0; c < n_corners; ++c)
            values[c].push_back(factors.values[c][i]);
        }
      else
        for (std::size_t corner = 0; corner < n_corners; ++corner)
          {
            if (factors.values[corner][i] == 0.)
              continue;
            patterns.push_back(system.assemble_load(i, factors.corners[corner]));
            scale(patterns.back(), factors.values[corner][i]);
            for (std::size_t c = 0; c < n_corners; ++c)
              values[c].push_back(c == corner ? 1. : 0.);
          }

    std::vector<double> levels;
    for (std::size_t s = 0; s < model.stages.size(); ++s)
      for (unsigned int i = 1; i <= model.stages[s].levels; ++i)
        levels.push_back(static_cast<double>(s) + static_cast<double>(i) / model.stages[s].levels);
    return {std::move(patterns),
            LoadHistory(factors.corners, std::move(values)),
            std::move(levels),
            std::move(report),
            LoadHistory(factors.corners, factors.values)};
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

  template LoadHistory
  make_load_history<2>(const ModelDefinition &);
  template LoadProgram
  make_load_program(const ModelDefinition &, const CondensedSystem<2> &);
} // namespace fuga
