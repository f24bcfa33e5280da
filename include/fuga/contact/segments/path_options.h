// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_path_options_h
#define fuga_contact_segments_path_options_h

#include <fuga/base/fields.h>

#include <cstddef>

namespace fuga
{
  /** Options that control how a path is followed. */
  struct PathOptions
  {
    enum class Iteration
    {
      /** Newton's method with the tangent stiffness of the layer. */
      newton,
      /** The paper's iteration (3), (7), (8) with a constant matrix; it diverges where the layer
       * hardens too much. */
      constant_stiffness
    };

    enum class Follow
    {
      /** Follow the path from event to event. */
      events,
      /** Proceed from corner to corner of the loads by implicit steps where that is possible. */
      stage_ends
    };

    /** The action where the joints can go on in several ways. */
    enum class NonUnique
    {
      /** The path ends with Verdict::non_unique_continuation. */
      stop,
      /** The first continuation found is followed. */
      first,
      /** The continuation that dissipates most is followed. */
      largest_dissipation
    };

    Follow follow        = Follow::events;
    NonUnique non_unique = NonUnique::stop;
    /** True if continuations other than the one found are looked for. */
    bool looks_for_others = true;
    /** If true, the path jumps to an equilibrium near by, if there is one, where no continuous path
     * goes on. */
    bool follow_jumps = false;
    /** If true, the path goes on beyond a limit load, where the load falls or is constant. */
    bool beyond_limit = false;
    /** Amount by which the largest jump grows there [m]; 0 stands for ten times the largest jump at
     * the limit. */
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
    /** Energy that one step may lose relative to that work in any case, however long the path
     * is. */
    double least_energy_loss    = 1e-12;
    unsigned int max_iterations = 200;
  };

  /** Work done for nonlinear layers. */
  struct IterationCount
  {
    std::size_t n_solutions  = 0;
    std::size_t n_iterations = 0;
    std::size_t max_in_one   = 0;
    /** Largest energy that the nonlinear layers have stored: the scale of what a step may lose of
     * it. */
    double largest_energy = 0.;
    /** The largest loads up to then, measured by the reactions of the closed joints. */
    double largest_load = 0.;
    /** Energy that the steps have lost by interpolation [MN m]. */
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
