// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/run/simulation/simulation.h>

#include <fmt/format.h>

namespace fuga
{
  // No finite stress reaches the closure limit of a normal law. Where the shear stiffness grows
  // with closure, lips without shear reach the closure at which it is infinite, and sheared ones
  // come so near that no digit is left between both.
  template <int dim>
  std::string
  Simulation<dim>::limit_of_law() const
  {
    constexpr double nearest = 1e-8;
    const JointState &state  = last_state;
    for (std::size_t k = 0; k < state.states.size(); ++k)
      {
        const ContactElement &element = joint.elements[k];
        const double limit            = closure_limit(element);
        if (state.states[k] == ContactState::open ||
            limit == element.normal_law->deformation_limit())
          continue;
        const double closure = -gap(element, state, k);
        if (limit - closure > nearest * limit)
          continue;
        const Units &u = parameters.output.units;
        return fmt::format(
          "outside of the law: at load time {:.9g} element {} of joint '{}', at "
          "({:g}; {:g}; {:g}), is closed by {:.9g} {}, all but {:.1e} of its "
          "'Shear growth closure' of {:.9g} {}. There the shear stiffness of the law is "
          "infinite. Give a larger one, a stiffer normal law, or one with a closure limit below "
          "it.",
          state.t,
          element.number,
          model.joint_names[element.joint],
          element.position[0],
          element.position[1],
          element.position[2],
          closure,
          u.length,
          (limit - closure) / limit,
          limit,
          u.length);
      }
    return {};
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
