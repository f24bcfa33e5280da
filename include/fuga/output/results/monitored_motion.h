// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_monitored_motion_h
#define fuga_output_results_monitored_motion_h

#include <fuga/base/fields.h>
#include <fuga/bodies/dynamics_definition.h>
#include <fuga/bodies/program/monitor.h>

namespace fuga
{
  /** Of the monitors at the end of a whole step, by axes. */
  struct MotionSample
  {
    std::array<double, 3> displacement, acceleration;
  };

  /** All samples of a motion. */
  struct MotionSamples
  {
    /** By monitors. */
    std::vector<std::vector<MotionSample>> of_monitors;
    /** Acceleration of the frame. */
    std::vector<std::array<double, 3>> of_frame;
  };

  template <typename Samples, typename Visitor, only_for<Samples, MotionSamples> = 0>
  void
  for_each_field(Samples &samples, Visitor &&visit)
  {
    auto &[of_monitors, of_frame] = samples;
    visit("of_monitors", of_monitors);
    visit("of_frame", of_frame);
  }

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

    const MotionSamples &
    memory() const
    {
      return samples;
    }

    void
    restore(const MotionSamples &memory)
    {
      samples = memory;
    }

  private:
    const std::vector<Monitor> &monitors;
    const double step;
    /** By monitors and axes: whether any node that counts has no mass. */
    std::vector<std::array<bool, 3>> is_massless;
    MotionSamples samples;
  };
} // namespace fuga

#endif
