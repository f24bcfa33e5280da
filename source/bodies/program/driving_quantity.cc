// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/program/driving_quantity.h>

#include <fmt/format.h>

#include <memory>

namespace fuga
{
  namespace
  {
    /** Fractions of a stage at which a course is sampled; they are irregular, so that no common
     * periodic function appears to be constant. */
    constexpr double sampled_fractions[] = {0., 0.1931, 0.4391, 0.6877, 0.8123, 1.};

    template <typename Course>
    bool
    moves(const Course &course, const double begin)
    {
      const double first = course(begin);
      for (const double fraction : sampled_fractions)
        if (course(begin + fraction) != first)
          return true;
      return false;
    }

    std::function<double(double)>
    course_of_safety(const StageDefinition &stage, const double begin)
    {
      const double largest = stage.largest_factor;
      if (stage.purpose == StagePurpose::load_factor)
        return [=](const double t) { return 1. + (largest - 1.) * (t - begin); };
      // The remaining share of strength is linear in t.
      return [=](const double t) { return 1. / (1. + (1. / largest - 1.) * (t - begin)); };
    }
  } // namespace

  std::string
  DrivingQuantity::text() const
  {
    return fmt::format("{} = {:.6g}", name, value);
  }

  DrivingQuantities::DrivingQuantities(const ModelDefinition &model,
                                       const LoadHistory &load_factors)
  {
    std::vector<Course> levels, factors;
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      {
        const LoadDefinition &load = model.loads[i];
        const auto factor          = [load_factors, i](const double t) {
          return load_factors.factors(t)[i];
        };
        factors.push_back({"factor of " + load.name, factor});
        if (!load.has_level())
          continue;
        const auto level = std::make_shared<LevelHistory>(load, model.constants);
        levels.push_back(
          {"level of " + load.name, [level](const double t) { return (*level)(t); }});
      }
    for (std::size_t s = 0; s < model.stages.size(); ++s)
      {
        const double begin           = static_cast<double>(s);
        const StageDefinition &stage = model.stages[s];
        if (stage.purpose != StagePurpose::loading)
          {
            const bool reduces = stage.purpose == StagePurpose::strength_reduction;
            courses.push_back({reduces ? "F" : "load factor", course_of_safety(stage, begin)});
            continue;
          }
        Course found{"fraction of the stage", [begin](const double t) { return t - begin; }};
        for (std::size_t i = factors.size(); i-- > 0;)
          if (moves(factors[i].value, begin))
            found = factors[i];
        std::size_t n_levels = levels.size();
        for (std::size_t i = model.loads.size(); i-- > 0;)
          if (model.loads[i].has_level() && moves(levels[--n_levels].value, begin) &&
              (factors[i].value(begin) != 0. || factors[i].value(begin + 1.) != 0.))
            found = levels[n_levels];
        courses.push_back(found);
      }
  }

  DrivingQuantity
  DrivingQuantities::at(const double t, const std::size_t stage) const
  {
    const Course &course = courses[stage];
    return {course.name, course.value(t)};
  }
} // namespace fuga
