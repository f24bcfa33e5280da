// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/monitor.h>

namespace fuga
{
  template <int dim>
  Monitor::Monitor(const std::string &name,
                   const MonitorPoint<dim> &point,
                   const CondensedSystem<dim> &system)
    : its_name(name)
  {
    for (unsigned int c = 0; c < dim; ++c)
      {
        its_position[c] = point.position()[c];
        components.push_back(system.response(point.unit_force(c)));
      }
  }

  std::array<double, 3>
  Monitor::displacement(const Vector &x, const Vector &a) const
  {
    std::array<double, 3> u{};
    for (std::size_t c = 0; c < components.size(); ++c)
      u[c] = components[c].value(x, a);
    return u;
  }

  template Monitor::Monitor(const std::string &,
                            const MonitorPoint<2> &,
                            const CondensedSystem<2> &);
} // namespace fuga
