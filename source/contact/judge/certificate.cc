// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/not_a_number.h>
#include <fuga/contact/judge/certificate.h>

namespace fuga
{
  double
  Certificate::worst() const
  {
    double largest = 0.;
    for (const auto &entry : entries())
      largest = larger_error(largest, entry.second);
    return largest;
  }

  std::array<std::pair<std::string_view, double>, 9>
  Certificate::entries() const
  {
    return {{{"equilibrium", equilibrium},
             {"body equilibrium", body_equilibrium},
             {"penetration", penetration},
             {"tension", tension},
             {"cone", cone},
             {"complementarity", complementarity},
             {"slip direction", slip_direction},
             {"layer law", layer_law},
             {"energy", energy}}};
  }

  void
  Certificate::absorb(const Certificate &other)
  {
    for (double Certificate::*entry : {&Certificate::equilibrium,
                                       &Certificate::body_equilibrium,
                                       &Certificate::penetration,
                                       &Certificate::tension,
                                       &Certificate::cone,
                                       &Certificate::complementarity,
                                       &Certificate::slip_direction,
                                       &Certificate::layer_law,
                                       &Certificate::energy})
      this->*entry = larger_error(this->*entry, other.*entry);
  }
} // namespace fuga
