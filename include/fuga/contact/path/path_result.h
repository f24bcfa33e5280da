// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_path_result_h
#define fuga_contact_path_path_result_h

#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/segments/curved_segment.h>

namespace fuga
{
  /** The way in which a path ended. */
  enum class Verdict
  {
    /** The requested end of the load history was reached. */
    done,
    /** The working scheme is a mechanism: the load cannot grow. */
    limit_load,
    /** No quasi-static continuation exists although nothing moves freely (friction beyond
       critical). */
    no_continuation,
    /** Several continuations exist (friction beyond critical), and the path was told not to
     * choose. */
    non_unique_continuation
  };

  /** Information about the first place on a path where friction was found to be beyond its critical
   * value. */
  struct CriticalFriction
  {
    double t = 0.;
    /** The elements on their strength that decide: no others differ between the continuations. */
    std::vector<std::size_t> elements;
    /** Number of continuations; a lower bound if not `all_counted`. */
    std::size_t n_branches = 0;
    bool all_counted       = false;
    /** Signs of the determinants of the schemes of the continuations; if there is no continuation,
     * the sign for the scheme in which all elements on their strength slip. */
    std::vector<int> determinant_signs;
  };

  template <typename Place, typename Visitor, only_for<Place, CriticalFriction> = 0>
  void
  for_each_field(Place &place, Visitor &&visit)
  {
    auto &[t, elements, n_branches, all_counted, determinant_signs] = place;
    visit("t", t);
    visit("elements", elements);
    visit("n_branches", n_branches);
    visit("all_counted", all_counted);
    visit("determinant_signs", determinant_signs);
  }

  /** The course of the path beyond its limit load. */
  struct BeyondLimit
  {
    enum class End
    {
      /** The path did not go beyond the limit. */
      none,
      /** The largest jump has grown as far as requested. */
      largest_jump,
      /** The load has fallen to where its stage, or the linear piece of it, began. */
      load_removed,
      /** The load has risen to the limit again. */
      limit_regained,
      /** No motion goes on at any load. */
      no_continuation
    };

    End end = End::none;
    /** Growth of the largest jump [m]. */
    double length = 0.;
    /** Load time at the end. */
    double t            = 0.;
    std::size_t n_steps = 0;
  };

  template <typename Way, typename Visitor, only_for<Way, BeyondLimit> = 0>
  void
  for_each_field(Way &way, Visitor &&visit)
  {
    auto &[end, length, t, n_steps] = way;
    visit("end", end);
    visit("length", length);
    visit("t", t);
    visit("n_steps", n_steps);
  }

  /** A jump from a state that no continuous path leaves to another equilibrium near by. */
  struct Jump
  {
    bool found = false;
    /** Load time before the jump, and its increase in the jump. */
    double t = 0., length = 0.;
    /** Largest change of a jump of the joints [m]. */
    double size = 0.;
    /** Energy that bodies, layers and loads release, and the part of it that friction takes in a
     * slow motion; the rest becomes motion [MNm]. */
    double released = 0., dissipated = 0.;
    /** The size if the equilibrium is sought with a hundredth of that length, if this was done
     * [m]. */
    double size_nearer = 0.;

    /** Return whether the jump shows that no continuous path leads to its end: its size does not
     * decrease with its length, and it releases more energy than friction takes. */
    bool
    shows_instability() const
    {
      return found && size_nearer > 0.5 * size && released > dissipated;
    }
  };

  template <typename OneJump, typename Visitor, only_for<OneJump, Jump> = 0>
  void
  for_each_field(OneJump &jump, Visitor &&visit)
  {
    auto &[found, t, length, size, released, dissipated, size_nearer] = jump;
    visit("found", found);
    visit("t", t);
    visit("length", length);
    visit("size", size);
    visit("released", released);
    visit("dissipated", dissipated);
    visit("size_nearer", size_nearer);
  }

  struct PathResult
  {
    Verdict verdict         = Verdict::done;
    double t                = 0.;
    MechanismKind mechanism = MechanismKind::none;
    /** Jumps of the bars in the mechanism, scaled to a largest one of 1. */
    Vector mechanism_jumps;
    std::size_t n_events     = 0;
    std::size_t n_zero_steps = 0;
    std::size_t n_steps      = 0;
    /** Number of implicit steps that replaced events. */
    std::size_t n_jumps    = 0;
    unsigned int n_schemes = 0;
    /** Number of continuations found by each RateMethod. */
    std::array<std::size_t, 4> n_decided_by = {{0, 0, 0, 0}};
    /** Number of decisions with several continuations. */
    std::size_t n_non_unique = 0;
    CriticalFriction critical;
    BeyondLimit beyond;
    /** The last jump, and the number of jumps that the path followed. */
    Jump jump;
    std::size_t n_followed_jumps = 0;
    /** Number of those jumps that were made because the path could not be computed. */
    std::size_t n_failures = 0;
    /** Description of what was tried, where a path ends with `no_continuation` only because no way
     * on was found: without a proof this is no verdict, see prove_limit(). Empty otherwise. */
    std::string tried;
    /** Virtual rates that may then prove it; empty if there are none. */
    JointRates barrier;
  };

  template <typename Result, typename Visitor, only_for<Result, PathResult> = 0>
  void
  for_each_field(Result &result, Visitor &&visit)
  {
    auto &[verdict,
           t,
           mechanism,
           mechanism_jumps,
           n_events,
           n_zero_steps,
           n_steps,
           n_jumps,
           n_schemes,
           n_decided_by,
           n_non_unique,
           critical,
           beyond,
           jump,
           n_followed_jumps,
           n_failures,
           tried,
           barrier] = result;
    visit("verdict", verdict);
    visit("t", t);
    visit("mechanism", mechanism);
    visit("mechanism_jumps", mechanism_jumps);
    visit("n_events", n_events);
    visit("n_zero_steps", n_zero_steps);
    visit("n_steps", n_steps);
    visit("n_jumps", n_jumps);
    visit("n_schemes", n_schemes);
    visit("n_decided_by", n_decided_by);
    visit("n_non_unique", n_non_unique);
    visit("critical", critical);
    visit("beyond", beyond);
    visit("jump", jump);
    visit("n_followed_jumps", n_followed_jumps);
    visit("n_failures", n_failures);
    visit("tried", tried);
    visit("barrier", barrier);
  }

  /** The data that a path passes from segment to segment besides its state. */
  struct PathMemory
  {
    IterationCount iterations;
    SchemeMemory scheme;
    /** Memory of the scheme of the elements off their boundaries, where some elements have two
     * tangential bars. */
    SchemeMemory background;
  };

  template <typename Memory, typename Visitor, only_for<Memory, PathMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[iterations, scheme, background] = memory;
    visit("iterations", iterations);
    visit("scheme", scheme);
    visit("background", background);
  }

  /**
   * A place between two segments, where the load goes on, from which a path can be followed again,
   * bit for bit. Segments are never cut, since dividing them would change the steps along a curve.
   * Reports to the observer after the cut, levels for instance, are counted instead and not
   * repeated.
   */
  struct PathCut
  {
    JointState state;
    /** The result so far. */
    PathResult result;
    PathMemory memory;
    std::size_t next_level = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    /** The states in the segment before. */
    std::vector<ContactState> last_states;
    /** Number of reports to the observer since the cut. */
    std::size_t n_reports = 0;
  };

  template <typename Cut, typename Visitor, only_for<Cut, PathCut> = 0>
  void
  for_each_field(Cut &cut, Visitor &&visit)
  {
    auto &[state, result, memory, next_level, resticking, last_states, n_reports] = cut;
    visit("state", state);
    visit("result", result);
    visit("memory", memory);
    visit("next_level", next_level);
    visit("resticking", resticking);
    visit("last_states", last_states);
    visit("n_reports", n_reports);
  }
} // namespace fuga

#endif
