// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_campaign_random_h
#define fuga_tests_campaign_random_h

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fuga::campaign
{
  /** Numbers that depend on a name and a seed only, the same with every standard library. */
  class Random
  {
  public:
    Random(const std::string &name, const std::uint64_t seed)
    {
      std::uint64_t state = 1469598103934665603u; // FNV-1a
      for (const char c : name)
        state = (state ^ static_cast<unsigned char>(c)) * 1099511628211u;
      generator.seed(state ^ (seed * 0x9E3779B97F4A7C15u));
    }

    std::uint64_t
    bits()
    {
      return generator();
    }

    double
    uniform(const double low, const double high)
    {
      return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
    }

    /** 10 to a power between @p low and @p high. */
    double
    power_of_ten(const double low, const double high)
    {
      return std::pow(10., uniform(low, high));
    }

    /** From @p low to @p high, both included. */
    unsigned int
    integer(const unsigned int low, const unsigned int high)
    {
      return low + static_cast<unsigned int>(generator() % (high - low + 1));
    }

    bool
    chance(const double probability)
    {
      return uniform(0., 1.) < probability;
    }

    double
    sign()
    {
      return chance(0.5) ? 1. : -1.;
    }

    template <typename T>
    T
    one_of(const std::vector<T> &values)
    {
      return values[generator() % values.size()];
    }

  private:
    std::mt19937_64 generator;
  };
} // namespace fuga::campaign

#endif
