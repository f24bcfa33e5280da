// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/program/load_knots.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Knots that are closer than this share of a stage are one. */
    constexpr double knot_tolerance = 1e-9;

    /** Return the time at which the level is @p wanted, between two times at one of which it is
     * lower and at the other one higher. */
    double
    crossing(const LevelHistory &level, const double wanted, double t0, double t1)
    {
      const bool rising = level(t1) > wanted;
      for (double middle = (t0 + t1) / 2.; middle != t0 && middle != t1; middle = (t0 + t1) / 2.)
        ((level(middle) > wanted) == rising ? t1 : t0) = middle;
      return rising ? t1 : t0;
    }

    /** Return whether the load is linear in t between two times between which the level is
     * linear. */
    bool
    is_linear(const DepthPressure &depth,
              const FactorCourse course,
              const std::vector<double> &kinks,
              const double level_0,
              const double level_1)
    {
      const double lowest = kinks.front(), highest = kinks.back();
      return level_0 == level_1 || (level_0 <= lowest && level_1 <= lowest) ||
             (depth.root == 0. && course == FactorCourse::constant && level_0 >= highest &&
              level_1 >= highest);
    }
  } // namespace


  LoadKnots::LoadKnots(const ModelDefinition &model_definition,
                       std::vector<std::vector<double>> kinks)
    : model(model_definition), kinks_of_loads(std::move(kinks))
  {
  }


  unsigned int
  LoadKnots::number_of_pieces(const std::size_t stage) const
  {
    const StageDefinition &definition = model.stages[stage];
    return definition.is_dynamic()
             ? static_cast<unsigned int>(number_of_time_steps(model.dynamics, definition))
             : model.load_knots;
  }


  void
  LoadKnots::add_level_knots(const unsigned int number,
                             const LevelDefinition &definition,
                             const std::size_t stage,
                             const FactorCourse course,
                             std::vector<double> &special,
                             std::vector<bool> &uniform) const
  {
    const double begin               = static_cast<double>(stage);
    const unsigned int n             = number_of_pieces(stage);
    const LoadDefinition &load       = model.loads[number];
    const std::vector<double> &kinks = kinks_of_loads[number];
    const LevelHistory level(definition, load, model.constants);
    const bool linear = level.is_piecewise_linear(begin, begin + 1.);

    // On each of these pieces the level is linear, or the piece is so short that it passes a kink
    // once at most.
    std::vector<double> times = {begin};
    if (linear)
      for (const double t : level.corners(begin, begin + 1.))
        times.push_back(t);
    else
      for (unsigned int i = 1; i < n; ++i)
        times.push_back(begin + static_cast<double>(i) / n);
    times.push_back(begin + 1.);
    for (std::size_t k = 0; k + 1 < times.size(); ++k)
      for (const double kink : kinks)
        if ((level(times[k]) - kink) * (level(times[k + 1]) - kink) < 0.)
          special.push_back(crossing(level, kink, times[k], times[k + 1]));
    if (linear)
      special.insert(special.end(), times.begin() + 1, times.end() - 1);
    std::sort(special.begin(), special.end());

    times = special;
    times.insert(times.begin(), begin);
    times.push_back(begin + 1.);
    for (std::size_t k = 0; k + 1 < times.size(); ++k)
      if (!linear || !is_linear(load.depth, course, kinks, level(times[k]), level(times[k + 1])))
        for (unsigned int i = 1; i < n; ++i)
          if (const double t = begin + static_cast<double>(i) / n; t > times[k] && t < times[k + 1])
            uniform[i] = true;
  }


  std::vector<double>
  LoadKnots::fractions(const std::size_t stage,
                       const std::vector<FactorCourse> &courses,
                       const bool straight) const
  {
    const unsigned int n = number_of_pieces(stage);
    std::vector<bool> uniform(n + 1, !straight);
    std::vector<double> special;
    for (unsigned int i = 0; i < model.loads.size(); ++i)
      if (courses[i] != FactorCourse::none && depends_on_time(model.loads[i]))
        {
          if (!model.loads[i].has_level())
            uniform.assign(n + 1, true);
          else if (!kinks_of_loads[i].empty())
            {
              const LoadDefinition &load = model.loads[i];
              const auto add             = [&](const LevelDefinition &level) {
                std::vector<double> times;
                add_level_knots(i, level, stage, courses[i], times, uniform);
                for (const double t : times)
                  special.push_back(t - static_cast<double>(stage));
              };
              add(load.depth);
              if (load.uplift.has_tailwater)
                add(load.uplift.tailwater);
            }
        }
    std::vector<double> candidates = special, knots;
    const auto is_near             = [&](const double s) {
      return std::any_of(special.begin(), special.end(), [&](const double other) {
        return std::abs(s - other) <= knot_tolerance;
      });
    };
    for (unsigned int i = 1; i < n; ++i)
      if (const double s = static_cast<double>(i) / n; uniform[i] && !is_near(s))
        candidates.push_back(s);
    std::sort(candidates.begin(), candidates.end());
    for (const double s : candidates)
      if (s > (knots.empty() ? 0. : knots.back()) + knot_tolerance && s < 1. - knot_tolerance)
        knots.push_back(s);
    knots.push_back(1.);
    return knots;
  }
} // namespace fuga
