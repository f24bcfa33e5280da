// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    double
    unreleased_tension(const ContactElement &element, const JointState &at)
    {
      return std::max(at.unreleased[element.normal_bar], 0.);
    }

    /** Return the force by which lips press each other [MN]: the amount by which N is below the
     * tension that a broken bond has not yet released. Under tension a bond has less strength, and
     * so has one that is released; otherwise a tension is rounding. */
    double
    pressing_force(const ContactElement &element,
                   const JointState &at,
                   const std::size_t k,
                   const double N)
    {
      const double tension = unreleased_tension(element, at);
      const bool is_bonded = at.strengths[k].tension > 0. || tension > 0.;
      return (is_bonded ? -N : std::max(-N, 0.)) + tension;
    }
  } // namespace

  double
  unreleased_shear(const ContactElement &element, const JointState &at)
  {
    return element.has_tangential_bar() ? length(tangential(element, at.unreleased)) : 0.;
  }

  StrengthLine
  strength_line(const ContactElement &element,
                const JointState &at,
                const std::size_t k,
                const double N)
  {
    const StrengthEnvelope &envelope = element.friction.envelope;
    const double tension             = unreleased_tension(element, at);
    StrengthLine line{at.strengths[k].friction,
                      at.strengths[k].cohesion + unreleased_shear(element, at)};
    if (envelope.is_curved())
      {
        const double pressure = pressing_force(element, at, k, N) / element.area;
        const double slope    = envelope.slope(pressure);
        line.cohesion +=
          line.friction * element.area * (envelope.value(pressure) - slope * pressure);
        line.friction *= slope;
      }
    line.cohesion += line.friction * tension;
    return line;
  }

  double
  strength_slope(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const StrengthEnvelope &envelope = element.friction.envelope;
    return envelope.is_curved()
             ? envelope.slope(pressing_force(element, at, k, at.forces[element.normal_bar]) /
                              element.area)
             : 1.;
  }

  double
  shear_strength(const ContactElement &element,
                 const JointState &at,
                 const std::size_t k,
                 const double N)
  {
    const Strength &left  = at.strengths[k];
    const double pressing = pressing_force(element, at, k, N);
    return std::max(0.,
                    left.friction * resisting_force(element.friction, element.area, pressing) +
                      left.cohesion + unreleased_shear(element, at));
  }

  double
  tensile_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return at.strengths[k].tension + unreleased_tension(element, at);
  }

  double
  tensile_strength_rate(const ContactElement &element, const Drive &drive)
  {
    double rate = drive.release.empty() ? 0. : std::min(drive.release[element.normal_bar], 0.);
    if (!drive.strength.empty())
      rate += drive.strength[element.normal_bar];
    return rate;
  }

  double
  shear_strength_rate(const ContactElement &element, const double friction, const Drive &drive)
  {
    double rate = drive.release.empty()
                    ? 0.
                    : friction * std::min(drive.release[element.normal_bar], 0.) -
                        length(tangential(element, drive.release));
    if (!drive.strength.empty())
      rate += drive.strength[element.tangential_bar];
    return rate;
  }
} // namespace fuga
