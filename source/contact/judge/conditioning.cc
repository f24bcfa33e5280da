// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/judge/conditioning.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fuga
{
  namespace
  {
    /** One unit in the fourth last binary digit, and the number of multiples of it that are
     * tried. */
    constexpr double last_digits = 0x1p-50;
    constexpr int n_changes      = 2;

    // Every operation rounds by as much as the data were changed, and a few of these errors may add
    // up.
    constexpr double same_size = 0.1;

    /** Return the same loads times @p factor. */
    LoadHistory
    scaled(const LoadHistory &history, const double factor)
    {
      std::vector<double> corners = {0.};
      while (corners.back() < history.end())
        corners.push_back(history.next_corner(corners.back()));
      std::vector<Vector> factors;
      Vector shares;
      for (const double corner : corners)
        {
          factors.push_back(history.factors(corner));
          for (double &value : factors.back())
            value *= factor;
          shares.push_back(history.strength_share(corner));
        }
      LoadHistory result(corners, factors, shares);
      for (std::size_t i = 1; i < corners.size(); ++i)
        if (history.water_stands_still(corners[i - 1]))
          result.keep_water_still(corners[i - 1], corners[i]);
      return result;
    }

    /** States at the levels, followed by the last of all. */
    class LevelRecord : public PathObserver
    {
    public:
      explicit LevelRecord(const LayeredSystem &layered_system) : system(layered_system)
      {
      }

      void
      advanced(const PathPoint &, const PathPoint &to, const double) override
      {
        end = to.state;
      }

      void
      jumped(const JointState &to) override
      {
        end = to;
      }

      void
      changed(const std::vector<ContactEvent> &, const JointState &state) override
      {
        end = state;
      }

      void
      reached(const std::size_t, const JointState &state) override
      {
        note(state);
      }

      void
      note(const JointState &state)
      {
        if (state.states.empty())
          return;
        constexpr double digit = std::numeric_limits<double>::epsilon();
        for (std::size_t bar = 0; bar < state.forces.size(); ++bar)
          last_digit = std::max(last_digit,
                                digit * std::abs(state.dislocations[bar]) * system.scale(bar) *
                                  system.scale(bar));
        forces.push_back(state.forces);
        jumps.push_back(system.jumps(state.dislocations, state.forces));
      }

      const LayeredSystem &system;
      JointState end;
      std::vector<Vector> forces, jumps;
      /** Effect of the last digit of a dislocation as a force [MN]. */
      double last_digit = 0.;
    };

    double
    largest(const std::vector<Vector> &values)
    {
      double size = 0.;
      for (const Vector &of_level : values)
        size = std::max(size, max_abs(of_level));
      return size;
    }

    /** Return @p value relative to the largest of @p values; 0 where all of them are zero, because
     * the ratio then means nothing. */
    double
    beside(const double value, const std::vector<Vector> &values)
    {
      const double size = largest(values);
      return size > 0. ? value / size : 0.;
    }

    /** Return the largest difference relative to the largest value. */
    double
    difference(const std::vector<Vector> &a, const std::vector<Vector> &b)
    {
      double result = 0.;
      for (std::size_t level = 0; level < std::min(a.size(), b.size()); ++level)
        for (std::size_t i = 0; i < a[level].size(); ++i)
          result = std::max(result, std::abs(a[level][i] - b[level][i]));
      return beside(result, a);
    }
  } // namespace

  bool
  Conditioning::explains_by_loads(const double error) const
  {
    // An error that is larger than any rounding means a wrong path, however strongly the loads
    // affect the answer.
    constexpr double largest_of_rounding = 1e-6;
    return error <= largest_of_rounding &&
           (other_end || std::max(forces, jumps) >= same_size * error);
  }

  bool
  Conditioning::explains_by_last_digit(const double error) const
  {
    return last_digit >= same_size * error;
  }

  Conditioning
  conditioning(const std::function<std::unique_ptr<ContactPath>(const LoadHistory &)> &make_path,
               const LayeredSystem &system,
               const LoadHistory &history,
               const std::vector<double> &levels,
               const std::function<bool(const Conditioning &)> &enough)
  {
    // Where the path fails, an end that it reaches under other loads is another one. Two failures
    // say nothing about the data, wherever they are.
    const auto follow = [&](const LoadHistory &loads, LevelRecord &record) {
      std::optional<Verdict> verdict;
      try
        {
          verdict = make_path(loads)->run(levels, record).verdict;
        }
      catch (const NumericalFailure &)
        {
        }
      record.note(record.end);
      return verdict;
    };
    LevelRecord record(system);
    const std::optional<Verdict> verdict = follow(history, record);
    Conditioning worst;
    worst.last_digit = beside(record.last_digit, record.forces);
    for (int k = 1; k <= n_changes && !(enough && enough(worst)); ++k)
      {
        LevelRecord other(system);
        worst.change                         = k * last_digits;
        const std::optional<Verdict> changed = follow(scaled(history, 1. + worst.change), other);
        worst.forces = std::max(worst.forces, difference(record.forces, other.forces));
        worst.jumps  = std::max(worst.jumps, difference(record.jumps, other.jumps));
        worst.other_end |=
          changed != verdict ||
          (verdict && (record.forces.size() != other.forces.size() ||
                       std::abs(other.end.t - record.end.t) > 1e-6 * std::max(1., record.end.t)));
      }
    return worst;
  }
} // namespace fuga
