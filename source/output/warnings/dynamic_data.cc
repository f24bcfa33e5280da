// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/dynamics/ground_motion.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/values/parameter_scanner.h>
#include <fuga/output/files/text_table.h>
#include <fuga/output/warnings/dynamic_data.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Range of peak accelerations of earthquakes that are computed [g]. */
    constexpr double smallest_peak = 0.005, largest_peak = 2.;

    /** Shares of the largest velocity and displacement; only a lost baseline leaves more than
     * that. */
    constexpr double velocity_left = 0.05, displacement_left = 0.2;

    /** Share of the peak acceleration that a stage may leave out of a record. */
    constexpr double acceleration_left = 0.05;

    constexpr double longest_step = 0.02, part_of_period = 0.1, largest_damping = 0.2;

    class DynamicReview
    {
    public:
      explicit DynamicReview(const Parameters &run_parameters)
        : parameters(run_parameters)
        , model(parameters.model)
        , dynamics(model.dynamics)
        , length(parameters.output.units.length)
      {
      }

      void
      bodies()
      {
        const BodyEntries &e      = entries_of<BodyEntries>();
        const DynamicsEntries &of = entries_of<DynamicsEntries>();
        for (const Material &material : model.materials)
          if (material.weight_density == 0. && moves(material) &&
              !dynamics.is_massless(material.body))
            warnings.push_back(
              fmt::format("{} = 0: the body has no inertia where bodies move. If that is "
                          "meant, name it in {}.",
                          path_name({e.name, material.body, e.weight_density.name()}),
                          path_name({of.name, of.massless_bodies.name()})));
        if (dynamics.damping_ratio > largest_damping)
          warnings.push_back(fmt::format(
            "{} = {:g} is unusual; usual is at most {:g}. It is a share of the critical "
            "damping; concrete and rock have about 0.05.",
            path_name({of.name, of.damping_ratio.name()}),
            dynamics.damping_ratio,
            largest_damping));
        if (dynamics.second_order != SecondOrder::none && model.stages.front().is_dynamic())
          warnings.push_back(fmt::format(
            "{} = {} does nothing in stage '{}', with which the file begins: nothing stresses the "
            "bodies before it. Let a stage without a Duration put their weight on.",
            path_name({of.name, of.second_order.name()}),
            of.second_order.word_of(dynamics.second_order),
            model.stages.front().name));
      }

      void
      ground()
      {
        for (std::size_t axis = 0; axis < dynamics.ground.size(); ++axis)
          if (!dynamics.ground[axis].accelerations.empty())
            {
              peak(axis);
              baseline(axis);
              time_step(axis);
              end_of_stage(axis);
            }
      }

      std::vector<std::string> warnings;

    private:
      static std::string
      record(const std::size_t axis)
      {
        const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
        return path_name({e.name, e.records[axis].name()});
      }

      /** Return whether a body exists in a stage in which it may move. */
      bool
      moves(const Material &material) const
      {
        const bool may_lose_equilibrium =
          parameters.solver.beyond_limit == LimitLoadChoice::dynamic;
        for (unsigned int stage = 0; stage < model.stages.size(); ++stage)
          if ((may_lose_equilibrium || model.stages[stage].is_dynamic()) &&
              is_there(material, stage))
            return true;
        return false;
      }

      void
      peak(const std::size_t axis)
      {
        const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
        const double peak = max_abs(dynamics.ground[axis].accelerations) / dynamics.gravity;
        if (peak < smallest_peak || peak > largest_peak)
          warnings.push_back(fmt::format(
            "{}: the largest acceleration, {:.4g} g, is unusual; usual is {:g} g to {:g} "
            "g. Check '{}' and '{}'.",
            record(axis),
            peak,
            smallest_peak,
            largest_peak,
            e.unit.name(),
            e.scale.name()));
      }

      void
      baseline(const std::size_t axis)
      {
        if (dynamics.baseline == Baseline::keep)
          return;
        const EarthquakeEntries &e = entries_of<EarthquakeEntries>();
        const auto [v, u]          = integrated(dynamics.ground[axis]);
        if (std::abs(v.back()) <= velocity_left * max_abs(v) &&
            std::abs(u.back()) <= displacement_left * max_abs(u))
          return;
        const std::string remedy =
          dynamics.baseline == Baseline::warn
            ? fmt::format("{}, or ", e.baseline.word_of(Baseline::parabolic))
            : "";
        warnings.push_back(fmt::format(
          "{}: the ground ends with a velocity of {:.3g} {}/s (largest {:.3g}) and {:.3g} {} from "
          "where it began (largest {:.3g}); usual is at most {:g} % and {:g} % of the largest. See "
          "'{}': {}{} if it is meant.",
          record(axis),
          v.back(),
          length,
          max_abs(v),
          u.back(),
          length,
          max_abs(u),
          100. * velocity_left,
          100. * displacement_left,
          e.baseline.name(),
          remedy,
          e.baseline.word_of(Baseline::keep)));
      }

      void
      time_step(const std::size_t axis)
      {
        const DynamicsEntries &e = entries_of<DynamicsEntries>();
        const double period      = mean_period(dynamics.ground[axis]);
        const double usual       = std::min(longest_step, part_of_period * period);
        if (dynamics.time_step > usual)
          warnings.push_back(fmt::format(
            "{} = {:g} s is unusual for {}; usual is at most {:.2g} s. The mean period of the "
            "record is {:.3g} s, and a period should have {:g} steps at least.",
            path_name({e.name, e.time_step.name()}),
            dynamics.time_step,
            record(axis),
            usual,
            period,
            1. / part_of_period));
      }

      void
      end_of_stage(const std::size_t axis)
      {
        const GroundMotion &motion   = dynamics.ground[axis];
        const StageDefinition &stage = model.stages[dynamics.earthquake_stage];
        double left                  = 0.;
        for (std::size_t i = 0; i < motion.accelerations.size(); ++i)
          if (static_cast<double>(i) * motion.step > stage.duration)
            left = std::max(left, std::abs(motion.accelerations[i]));
        if (left > acceleration_left * max_abs(motion.accelerations))
          warnings.push_back(fmt::format(
            "{}: the record has up to {:.3g} g after the end of the stage '{}', {:g} s, "
            "usual is at most {:g} % of its largest acceleration. The record lasts {:g} "
            "s; see '{}' of the stage.",
            record(axis),
            left / dynamics.gravity,
            stage.name,
            stage.duration,
            100. * acceleration_left,
            duration_of(motion),
            entries_of<StageEntries>().duration.name()));
      }

      const Parameters &parameters;
      const ModelDefinition &model;
      const DynamicsDefinition &dynamics;
      const std::string &length;
    };
  } // namespace


  std::vector<std::string>
  implausible_dynamics(const Parameters &parameters)
  {
    if (!may_move(parameters))
      return {};
    DynamicReview review(parameters);
    review.bodies();
    review.ground();
    return review.warnings;
  }


  std::vector<std::string>
  ground_motion_echo(const Parameters &parameters)
  {
    const DynamicsDefinition &dynamics = parameters.model.dynamics;
    const std::string &length          = parameters.output.units.length;
    TextTable table({"axis",
                     "samples",
                     "step [s]",
                     "duration [s]",
                     "mean period [s]",
                     "largest a [g]",
                     fmt::format("v [{}/s]", length),
                     fmt::format("u [{}]", length),
                     fmt::format("at the end v [{}/s]", length),
                     fmt::format("u [{}]", length)});
    for (std::size_t axis = 0; axis < dynamics.ground.size(); ++axis)
      if (const GroundMotion &motion = dynamics.ground[axis]; !motion.accelerations.empty())
        {
          const auto [v, u] = integrated(motion);
          table.add({std::string(1, static_cast<char>('x' + axis)),
                     std::to_string(motion.accelerations.size()),
                     readable(motion.step),
                     readable(duration_of(motion)),
                     readable(mean_period(motion)),
                     readable(max_abs(motion.accelerations) / dynamics.gravity),
                     readable(max_abs(v)),
                     readable(max_abs(u)),
                     readable(v.back(), max_abs(v)),
                     readable(u.back(), max_abs(u))});
        }
    if (table.is_empty())
      return {};
    std::vector<std::string> lines = {
      fmt::format("Motion of the ground from the beginning of stage '{}'",
                  parameters.model.stages[dynamics.earthquake_stage].name)};
    const std::vector<std::string> rows = table.lines();
    lines.insert(lines.end(), rows.begin(), rows.end());
    return lines;
  }
} // namespace fuga
