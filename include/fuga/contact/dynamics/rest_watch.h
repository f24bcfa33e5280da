// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_rest_watch_h
#define fuga_contact_dynamics_rest_watch_h

#include <fuga/contact/dynamics/moving_bodies.h>

#include <algorithm>
#include <cstddef>

namespace fuga
{
  /** Detects when bodies have come to rest: their kinetic energy stays below a small share of its
   * largest value for half of the time that they have moved. Where they only turn back, it is that
   * small only for thousandths of that time. */
  class RestWatch
  {
  public:
    /** Note the kinetic energy after a step; all steps are equally long. */
    void
    note(const double kinetic_energy)
    {
      ++n_steps;
      largest = std::max(largest, kinetic_energy);
      if (kinetic_energy > TimeGrid::at_rest * largest)
        last_motion = n_steps;
    }

    bool
    has_come_to_rest() const
    {
      return n_steps > last_motion + last_motion / 2;
    }

  private:
    double largest      = 0.;
    std::size_t n_steps = 0, last_motion = 0;
  };
} // namespace fuga

#endif
