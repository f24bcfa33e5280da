// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_monitor_h
#define fuga_bodies_monitor_h

#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/monitor_point.h>

namespace fuga
{
  /**
   * The displacement of one point as a function of interface coordinates and load factors: two back
   * solutions before the path begins, and as many products as there are coordinates whenever it is
   * asked for. No field is recovered.
   */
  class Monitor
  {
  public:
    template <int dim>
    Monitor(const std::string &name,
            const MonitorPoint<dim> &point,
            const CondensedSystem<dim> &system);

    const std::string &
    name() const
    {
      return its_name;
    }

    const std::array<double, 3> &
    position() const
    {
      return its_position;
    }

    /** u [length] for interface coordinates @p x and load factors @p a. */
    std::array<double, 3>
    displacement(const Vector &x, const Vector &a) const;

  private:
    std::string its_name;
    std::array<double, 3> its_position{};
    std::vector<LinearResponse> components;
  };
} // namespace fuga

#endif
