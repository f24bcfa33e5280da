// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_monitored_motion_h
#define fuga_output_results_monitored_motion_h

#include <fuga/bodies/dynamics_definition.h>
#include <fuga/bodies/program/monitor.h>

namespace fuga
{
  /**
   * Collects the absolute accelerations of the monitors at the ends of whole steps of time.
   *
   * Those of a node with mass are what its forces demand, as the integration has them. Without mass
   * they follow from nothing but the rule of integration, and alternate from step to step; second
   * differences of the displacement take their place.
   */
  class MonitoredMotion
  {
  public:
    /** @p step: its length [s]; @p mass: diagonal of the mass matrix, by nodes. @p monitors must
     * live as long as this object. */
    MonitoredMotion(const std::vector<Monitor> &monitors, const double step, const Vector &mass);

    /** @p displacement and @p acceleration of all nodes in a frame that has the acceleration @p
     * of_frame. */
    void
    add(const Vector &displacement,
        const Vector &acceleration,
        const std::array<double, 3> &of_frame);

    /** By monitors and axes. */
    std::vector<std::array<GroundMotion, 3>>
    accelerations() const;

  private:
    struct Sample
    {
      std::array<double, 3> displacement, acceleration;
    };

    const std::vector<Monitor> &monitors;
    const double step;
    /** By monitors and axes: whether any node that counts has no mass. */
    std::vector<std::array<bool, 3>> is_massless;
    /** By monitors. */
    std::vector<std::vector<Sample>> samples;
    std::vector<std::array<double, 3>> frame;
  };
} // namespace fuga

#endif
