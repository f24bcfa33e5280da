// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_path_result_h
#define fuga_contact_path_path_result_h

#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/segments/curved_segment.h>

namespace fuga
{
  /** How a path ended. */
  enum class Verdict
  {
    /** The requested end of the load history was reached. */
    done,
    /** The working scheme is a mechanism: the load cannot grow. */
    limit_load,
    /** No quasi-static continuation exists although nothing moves freely (friction beyond
       critical). */
    no_continuation,
    /** Several continuations exist (friction beyond critical), and the path is not to choose. */
    non_unique_continuation
  };

  /** What is known of the first place on a path where friction was seen beyond its critical value.
   */
  struct CriticalFriction
  {
    double t = 0.;
    /** Elements on their strength that decide: no other ones differ between the continuations. */
    std::vector<std::size_t> elements;
    /** Number of continuations; a lower bound if not `all_counted`. */
    std::size_t n_branches = 0;
    bool all_counted       = false;
    /** Signs of the determinants of their schemes; if there is no continuation, of the scheme in
     * which all elements on their strength slip. */
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

  /** What the path did beyond its limit load. */
  struct BeyondLimit
  {
    enum class End
    {
      /** The path did not go there. */
      none,
      /** The largest jump has grown as far as asked for. */
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

  /** From a state that no continuous path leaves to another equilibrium near by. */
  struct Jump
  {
    bool found = false;
    /** Load time before it, and what it goes on by. */
    double t = 0., length = 0.;
    /** Largest change of a jump of the joints [m]. */
    double size = 0.;
    /** What bodies, layers and loads give off, and what of it friction takes in a slow motion; the
     * rest becomes motion [MNm]. */
    double released = 0., dissipated = 0.;
    /** The size where it is looked for with a hundredth of that length, if it is [m]. */
    double size_nearer = 0.;

    /** That no continuous path leads to its end: its size does not fall with its length, and it
     * sets free more than friction takes. */
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
    /** Jumps of the bars in the mechanism, largest 1. */
    Vector mechanism_jumps;
    std::size_t n_events     = 0;
    std::size_t n_zero_steps = 0;
    std::size_t n_steps      = 0;
    /** Implicit steps that took the place of events. */
    std::size_t n_jumps    = 0;
    unsigned int n_schemes = 0;
    /** Continuations found by each RateMethod. */
    std::array<std::size_t, 5> n_decided_by = {{0, 0, 0, 0, 0}};
    /** Decisions with several continuations. */
    std::size_t n_non_unique = 0;
    CriticalFriction critical;
    BeyondLimit beyond;
    /** The last one, and how many the path followed. */
    Jump jump;
    std::size_t n_followed_jumps = 0;
    /** Of these, where the path could not be computed. */
    std::size_t n_failures = 0;
    /** What was tried, where a path ends with `no_continuation` only because no way on was found:
     * without a proof this is no verdict, see prove_limit(). Empty otherwise. */
    std::string tried;
    /** Virtual rates that may prove it then; empty if there are none. */
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

  /** What a path takes along from segment to segment besides its state. */
  struct PathMemory
  {
    IterationCount iterations;
    SchemeMemory scheme;
    /** Of the elements off their boundaries, where some have two tangential bars. */
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
   * bit for bit. Segments are
   * never cut: where they are divided would change the steps along a curve. What the observer heard
   * behind the cut, levels for instance, is counted instead and not reported again.
   */
  struct PathCut
  {
    JointState state;
    /** What was found so far. */
    PathResult result;
    PathMemory memory;
    std::size_t next_level = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    /** Reports to the observer since the cut. */
    std::size_t n_reports = 0;
  };

  template <typename Cut, typename Visitor, only_for<Cut, PathCut> = 0>
  void
  for_each_field(Cut &cut, Visitor &&visit)
  {
    auto &[state, result, memory, next_level, resticking, n_reports] = cut;
    visit("state", state);
    visit("result", result);
    visit("memory", memory);
    visit("next_level", next_level);
    visit("resticking", resticking);
    visit("n_reports", n_reports);
  }
} // namespace fuga

#endif
