// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/bodies/program/load_jump.h>
#include <fuga/bodies/program/load_patterns.h>
#include <fuga/bodies/straightness.h>

namespace fuga
{
  namespace
  {
    /** Return the sum of the effects of a pattern, without signs. */
    double
    size_of(const LoadPattern &pattern)
    {
      double sum = 0.;
      for (const Vector *part :
           {&pattern.forces, &pattern.prescribed, &pattern.opening_water, &pattern.jumps})
        for (const double value : *part)
          sum += std::abs(value);
      return sum;
    }

    /** Return the size of the difference between a pattern and the mean of two others. */
    double
    distance_to_mean(LoadPattern middle, const LoadPattern &a, const LoadPattern &b)
    {
      for (Vector LoadPattern::*part : {&LoadPattern::forces,
                                        &LoadPattern::prescribed,
                                        &LoadPattern::opening_water,
                                        &LoadPattern::jumps})
        for (std::size_t i = 0; i < (middle.*part).size(); ++i)
          (middle.*part)[i] -= ((a.*part)[i] + (b.*part)[i]) / 2.;
      return size_of(middle);
    }
  } // namespace


  template <int dim>
  LoadPatterns<dim>::LoadPatterns(const ModelDefinition &model_definition,
                                  const CondensedSystem<dim> &condensed_system,
                                  const LoadFactors &load_factors)
    : values(load_factors.corners.size())
    , model(model_definition)
    , system(condensed_system)
    , factors(load_factors)
  {
    for (unsigned int i = 0; i < model.loads.size(); ++i)
      if (depends_on_time(model.loads[i]))
        add_changing(i);
      else
        {
          add(i, 0., system.assemble_load(i, 0.));
          for (std::size_t c = 0; c < values.size(); ++c)
            values[c].back() = factors.values[c][i];
        }
  }


  template <int dim>
  void
  LoadPatterns<dim>::add(const unsigned int load, const double t, LoadPattern pattern)
  {
    patterns.push_back(std::move(pattern));
    sources.push_back({load, t});
    for (Vector &corner : values)
      corner.push_back(0.);
  }


  // A pattern that is the same at the next corner widens the hat function; a zero pattern needs
  // none.
  template <int dim>
  void
  LoadPatterns<dim>::add_changing(const unsigned int load)
  {
    const std::size_t first = patterns.size();
    LoadPattern last;
    double size = 0., distance = 0.;
    bool has_last = false, last_is_pattern = false;
    for (std::size_t c = 0; c < values.size(); ++c)
      {
        const double t      = std::min(factors.corners[c], factors.end_of_loading);
        const double factor = factors.values[c][load];
        if (factor == 0. && (c + 1 == values.size() || factors.values[c + 1][load] == 0.))
          {
            has_last = last_is_pattern = false;
            continue;
          }
        LoadPattern next = system.assemble_load(load, t);
        const bool same  = has_last && next.forces == last.forces &&
                          next.prescribed == last.prescribed &&
                          next.opening_water == last.opening_water && next.jumps == last.jumps &&
                          next.levels.reservoir == last.levels.reservoir &&
                          next.levels.tailwater == last.levels.tailwater;
        if (has_last && !same)
          distance =
            std::max(distance,
                     distance_to_mean(
                       system.assemble_load(load, (factors.corners[c - 1] + t) / 2.), last, next));
        const double here = size_of(next);
        size              = std::max(size, here);
        if (here == 0. || factor == 0.)
          last_is_pattern = false;
        else
          {
            if (!same || !last_is_pattern)
              add(load, t, next);
            values[c].back() = factor;
            last_is_pattern  = true;
          }
        last     = std::move(next);
        has_last = true;
      }
    check_jumps(load, size);
    report.push_back(
      fmt::format("load '{}' changes with t: {} patterns; half-way between knots it differs from "
                  "its interpolation by at most {:.1e} of its largest value",
                  model.loads[load].name,
                  patterns.size() - first,
                  size > 0. ? distance / size : 0.));
  }


  template <int dim>
  void
  LoadPatterns<dim>::check_jumps(const unsigned int load, const double size) const
  {
    for (const LoadFactors::Jump &jump : factors.jumps)
      if (model.stages[jump.stage].histories[jump.history].load == load &&
          size_of(system.assemble_load(load, static_cast<double>(jump.stage))) >
            linear_tolerance * size)
        throw_jump(model, system, jump);
  }


  template class LoadPatterns<2>;
  template class LoadPatterns<3>;
} // namespace fuga
