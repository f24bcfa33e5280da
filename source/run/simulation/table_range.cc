// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/point_text.h>
#include <fuga/run/simulation/table_range.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  TableRange::TableRange(const std::vector<ContactElement> &contact_elements)
    : elements(contact_elements)
  {
    const auto add = [this](const std::size_t k, const ComplianceLaw &law, const bool normal) {
      if (std::isfinite(law.data_limit()))
        bars.push_back({k, normal, law.stress(law.data_limit()), 0., 0.});
    };
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        add(k, *elements[k].normal_law, true);
        if (elements[k].has_tangential_bar())
          add(k, *elements[k].shear_law, false);
      }
  }

  void
  TableRange::watch(const JointState &state)
  {
    for (Bar &bar : bars)
      {
        const ContactElement &element = elements[bar.element];
        const std::size_t number      = bar.normal ? element.normal_bar : element.tangential_bar;
        const double force            = state.forces[number];
        const double stress           = (bar.normal ? -force : std::abs(force)) / element.area;
        if (stress > bar.data_end && stress > bar.largest)
          {
            bar.largest = stress;
            bar.t       = state.t;
          }
      }
  }

  template <int dim>
  std::vector<std::string>
  TableRange::warnings(const std::vector<std::string> &joint_names,
                       const std::string &stress_unit) const
  {
    std::vector<std::string> result;
    for (std::size_t joint = 0; joint < joint_names.size(); ++joint)
      for (const bool normal : {true, false})
        {
          const Bar *worst = nullptr;
          for (const Bar &bar : bars)
            if (elements[bar.element].joint == joint && bar.normal == normal && bar.largest > 0. &&
                (worst == nullptr || bar.largest > worst->largest))
              worst = &bar;
          if (worst == nullptr)
            continue;
          const ContactElement &element = elements[worst->element];
          dealii::Point<dim> place;
          for (unsigned int c = 0; c < dim; ++c)
            place[c] = element.position[c];
          result.push_back(fmt::format(
            "joint '{}': the {} table ends at {:g} {}, but element {} at {} reaches "
            "{:.6g} at t = {:.6g}. Beyond its last point the table is continued by a straight "
            "line: "
            "add points.",
            joint_names[joint],
            normal ? "normal" : "shear",
            worst->data_end,
            stress_unit,
            element.number,
            text_of(place),
            worst->largest,
            worst->t));
        }
    return result;
  }

  template std::vector<std::string>
  TableRange::warnings<2>(const std::vector<std::string> &, const std::string &) const;
  template std::vector<std::string>
  TableRange::warnings<3>(const std::vector<std::string> &, const std::string &) const;
} // namespace fuga
