// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/segments/course.h>

#include <algorithm>

namespace fuga
{
  // Stages begin at whole numbers, whatever rounding says.
  double
  Course::time_at(const double tau) const
  {
    return tau == length ? t_end : t + tau * (t_end - t) / length;
  }

  Vector
  Course::factors_at(const double tau) const
  {
    Vector result = factors;
    for (std::size_t j = 0; j < factor_rates.size(); ++j)
      result[j] += tau * factor_rates[j];
    return result;
  }

  void
  reduce_strengths(const std::vector<ContactElement> &elements,
                   const Course &course,
                   const double tau,
                   std::vector<Strength> &strengths)
  {
    if (course.share_rate == 0.)
      return;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (const ContactElement &element = elements[k]; element.friction.reduced)
        reduce(
          strengths[k], element.friction, element.area, course.share + tau * course.share_rate);
  }

  // The strength that is left at the present pressure falls in proportion to the share s of it: at
  // the rate ṡ/s times itself.
  Drive
  drive_at(const std::vector<ContactElement> &elements,
           const Course &course,
           const JointState &state)
  {
    Drive drive = course.drive;
    if (course.share_rate == 0.)
      return drive;
    drive.strength.assign(state.forces.size(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const Strength &strength      = state.strengths[k];
        if (!element.friction.reduced || state.states[k] == ContactState::open)
          continue;
        const double rate                  = course.share_rate / strength.share;
        const double N                     = state.forces[element.normal_bar];
        drive.strength[element.normal_bar] = rate * strength.tension;
        drive.strength[element.tangential_bar] =
          rate * std::max(0., strength.cohesion - strength.friction * N);
      }
    return drive;
  }

  bool
  is_bent_by_reduction(const std::vector<ContactElement> &elements,
                       const Course &course,
                       const JointState &state)
  {
    if (course.share_rate != 0.)
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (elements[k].friction.reduced && is_slipping(state.states[k]))
          return true;
    return false;
  }
} // namespace fuga
