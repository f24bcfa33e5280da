// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_path_options_h
#define fuga_contact_segments_path_options_h

#include <fuga/base/fields.h>

#include <cstddef>

namespace fuga
{
  /** How nonlinear layers are iterated. */
  struct PathOptions
  {
    enum class Iteration
    {
      /** Newton with the tangent stiffness of the layer. */
      newton,
      /** The paper's iteration (3), (7), (8) with a constant matrix; diverges where the layer
         hardens too much. */
      constant_stiffness
    };

    enum class Follow
    {
      /** From event to event. */
      events,
      /** From corner to corner of the loads by implicit steps where that is possible. */
      stage_ends
    };

    /** What happens where the joints can go on in several ways. */
    enum class NonUnique
    {
      /** The path ends with Verdict::non_unique_continuation. */
      stop,
      /** The first continuation found is followed. */
      first,
      /** The one that dissipates most. */
      largest_dissipation
    };

    Follow follow        = Follow::events;
    NonUnique non_unique = NonUnique::stop;
    /** Whether other continuations than the one found are looked for. */
    bool looks_for_others = true;
    /** Where no continuous path goes on, the path jumps to an equilibrium near by if there is one.
     */
    bool follow_jumps = false;
    /** Goes on beyond a limit load, the load falling or constant. */
    bool beyond_limit = false;
    /** How far the largest jump grows there [m]; 0: ten times the largest jump at the limit. */
    double beyond_jump  = 0.;
    Iteration iteration = Iteration::newton;
    /** Difference of two successive iterations that ends the iteration, relative to the largest
     * jump. */
    double tolerance = 1e-13;
    /** Largest error of one step along a curve whose directions of slip turn, relative to the
     * largest force and jump. */
    double curve_tolerance = 1e-11;
    /** Energy that a path may lose by interpolation along curves, relative to the work of the bars.
     */
    static constexpr double largest_energy_loss = 3e-10;
    /** What one step may lose of that work in any case, be the path ever so long. */
    double least_energy_loss    = 1e-12;
    unsigned int max_iterations = 200;
  };

  /** Work done for nonlinear layers. */
  struct IterationCount
  {
    std::size_t n_solutions  = 0;
    std::size_t n_iterations = 0;
    std::size_t max_in_one   = 0;
    /** Largest energy the nonlinear layers stored: the scale of what a step may lose of it. */
    double largest_energy = 0.;
    /** The largest loads then, by the reactions of the closed joints. */
    double largest_load = 0.;
    /** Energy the steps have lost by interpolation [MN m]. */
    double energy_lost = 0.;
  };

  template <typename Count, typename Visitor, only_for<Count, IterationCount> = 0>
  void
  for_each_field(Count &count, Visitor &&visit)
  {
    auto &[n_solutions, n_iterations, max_in_one, largest_energy, largest_load, energy_lost] =
      count;
    visit("n_solutions", n_solutions);
    visit("n_iterations", n_iterations);
    visit("max_in_one", max_in_one);
    visit("largest_energy", largest_energy);
    visit("largest_load", largest_load);
    visit("energy_lost", energy_lost);
  }
} // namespace fuga

#endif
