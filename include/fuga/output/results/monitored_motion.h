// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_monitored_motion_h
#define fuga_output_results_monitored_motion_h

#include <fuga/base/fields.h>
#include <fuga/bodies/dynamics_definition.h>
#include <fuga/bodies/program/monitor.h>

namespace fuga
{
  /** Displacement and acceleration of a monitor at the end of a whole step, by axes. */
  struct MotionSample
  {
    std::array<double, 3> displacement, acceleration;
  };

  /** All samples of a motion. */
  struct MotionSamples
  {
    /** Samples by monitor. */
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
   * Collects the absolute accelerations of the monitors at the ends of whole time steps.
   *
   * The acceleration of a node with mass follows from its forces, as in the integration. Without
   * mass it follows from nothing but the rule of integration and alternates from step to step; it
   * is replaced by second differences of the displacement.
   */
  class MonitoredMotion
  {
  public:
    /**
     * @p step is the length of a step [s], @p mass the diagonal of the mass matrix, by nodes.
     * @p monitors must live as long as this object.
     */
    MonitoredMotion(const std::vector<Monitor> &monitors, const double step, const Vector &mass);

    /**
     * Add a sample from @p displacement and @p acceleration of all nodes in a frame that has the
     * acceleration @p of_frame.
     */
    void
    add(const Vector &displacement,
        const Vector &acceleration,
        const std::array<double, 3> &of_frame);

    /** Return the accelerations by monitor and axis. */
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
    /** Tells by monitor and axis whether any node that counts has no mass. */
    std::vector<std::array<bool, 3>> is_massless;
    MotionSamples samples;
  };
} // namespace fuga

#endif
