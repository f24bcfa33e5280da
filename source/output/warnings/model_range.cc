// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/point_text.h>
#include <fuga/output/warnings/model_range.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Share of the length of a joint: lips that slip by more do not lie opposite to each other. */
    constexpr double largest_slip = 0.05;

    /** Rotation beyond which its cosine is not 1. */
    constexpr double largest_turn = 0.1;

    void
    note(ModelExcess &excess,
         const double value,
         const double limit,
         const double t,
         const ContactElement &element)
    {
      if (value > excess.largest)
        excess = {value, limit, t, element.number, element.position};
    }

    // A joint of one element has the length that follows from its area.
    std::vector<double>
    lengths_of_joints(const std::vector<ContactElement> &elements, const std::size_t n_joints)
    {
      std::vector<double> areas(n_joints, 0.), squares(n_joints, 0.);
      for (const ContactElement &element : elements)
        areas[element.joint] += element.area;
      for (unsigned int c = 0; c < 3; ++c)
        {
          std::vector<double> first(n_joints, std::numeric_limits<double>::infinity());
          std::vector<double> last(n_joints, -std::numeric_limits<double>::infinity());
          for (const ContactElement &element : elements)
            {
              first[element.joint] = std::min(first[element.joint], element.position[c]);
              last[element.joint]  = std::max(last[element.joint], element.position[c]);
            }
          for (std::size_t joint = 0; joint < n_joints; ++joint)
            if (last[joint] > first[joint])
              squares[joint] += (last[joint] - first[joint]) * (last[joint] - first[joint]);
        }
      const bool in_space = have_two_tangents(elements);
      std::vector<double> lengths;
      for (std::size_t joint = 0; joint < n_joints; ++joint)
        lengths.push_back(
          std::max(std::sqrt(squares[joint]), in_space ? std::sqrt(areas[joint]) : areas[joint]));
      return lengths;
    }

    template <int dim>
    std::string
    place_of(const ModelExcess &excess)
    {
      dealii::Point<dim> place;
      for (unsigned int c = 0; c < dim; ++c)
        place[c] = excess.position[c];
      return fmt::format("element {} at {}", excess.element, text_of(place));
    }

    template <int dim>
    std::string
    beyond_table(const std::string &kind, const ModelExcess &excess, const Units &units)
    {
      return fmt::format("the {} table ends at {:g} {}, but {} reaches {:.6g} at t = {:.6g}. "
                         "Beyond its last point the table is continued by a straight line: "
                         "add points.",
                         kind,
                         excess.limit,
                         units.stress(),
                         place_of<dim>(excess),
                         excess.largest,
                         excess.t);
    }

    template <int dim>
    std::string
    far_slip(const ModelExcess &excess, const Units &units)
    {
      return fmt::format("{} slips by {:.4g} {} at t = {:.6g}, {:.2g} times the length of "
                         "the joint. Lips are taken to stay opposite to each other, which "
                         "is meant for less than {:g} times.",
                         place_of<dim>(excess),
                         excess.largest,
                         units.length,
                         excess.t,
                         excess.largest / excess.limit,
                         largest_slip);
    }

    std::string
    far_turn(const ModelExcess &excess, const Units &units)
    {
      return fmt::format("openings differ by {:.4g} {} at t = {:.6g}, {:.2g} times the "
                         "length of the joint: bodies turn by about that angle. "
                         "Displacements are taken for small, which is meant for less than "
                         "{:g}.",
                         excess.largest,
                         units.length,
                         excess.t,
                         excess.largest / excess.limit,
                         largest_turn);
    }
  } // namespace

  ModelRange::ModelRange(const std::vector<ContactElement> &contact_elements,
                         const std::size_t n_joints,
                         Record &record_of_run)
    : elements(contact_elements)
    , lengths(lengths_of_joints(elements, n_joints))
    , record(record_of_run)
    , openings(n_joints)
  {
    record.resize(n_joints);
    const auto note_table =
      [this](const ContactElement &element, const bool is_normal, const ComplianceLaw &law) {
        if (std::isfinite(law.data_limit()))
          tabulated_bars.push_back({&element, is_normal, law.stress(law.data_limit())});
      };
    for (const ContactElement &element : elements)
      {
        note_table(element, true, *element.normal_law);
        if (element.has_tangential_bar())
          note_table(element, false, *element.shear_law);
      }
  }

  void
  ModelRange::watch(const JointState &state)
  {
    watch_tables(state);
    watch_slips(state);
    watch_turns(state);
  }

  void
  ModelRange::watch_tables(const JointState &state)
  {
    for (const auto &[element, is_normal, end] : tabulated_bars)
      {
        const double stress = is_normal
                                ? -state.forces[element->normal_bar] / element->area
                                : std::abs(state.forces[element->tangential_bar]) / element->area;
        JointExcess &excess = record[element->joint];
        if (stress > end)
          note(
            is_normal ? excess.normal_table : excess.shear_table, stress, end, state.t, *element);
      }
  }

  void
  ModelRange::watch_slips(const JointState &state)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const unsigned int joint = elements[k].joint;
        if (const double way = length(state.slips[k]); way > largest_slip * lengths[joint])
          note(record[joint].slip, way, lengths[joint], state.t, elements[k]);
      }
  }

  void
  ModelRange::watch_turns(const JointState &state)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    openings.assign(openings.size(), {infinity, -infinity, nullptr});
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const double opening          = state.states[k] == ContactState::open
                                          ? element.initial_gap + state.dislocations[element.normal_bar]
                                          : 0.;
        auto &[least, most, widest]   = openings[element.joint];
        least                         = std::min(least, opening);
        if (opening > most)
          {
            most   = opening;
            widest = &element;
          }
      }
    for (std::size_t joint = 0; joint < lengths.size(); ++joint)
      if (const auto &[least, most, widest] = openings[joint];
          most - least > largest_turn * lengths[joint])
        note(record[joint].turn, most - least, lengths[joint], state.t, *widest);
  }

  template <int dim>
  std::vector<std::string>
  range_warnings(const ModelRange::Record &record,
                 const std::vector<std::string> &joint_names,
                 const Units &units)
  {
    std::vector<std::string> result;
    for (std::size_t joint = 0; joint < record.size(); ++joint)
      {
        const auto say = [&](const ModelExcess &excess, const std::string &sentence) {
          if (excess.largest > 0.)
            result.push_back(fmt::format("joint '{}': {}", joint_names[joint], sentence));
        };
        const auto &[normal_table, shear_table, slip, turn] = record[joint];
        say(normal_table, beyond_table<dim>("normal", normal_table, units));
        say(shear_table, beyond_table<dim>("shear", shear_table, units));
        say(slip, far_slip<dim>(slip, units));
        say(turn, far_turn(turn, units));
      }
    return result;
  }

  template std::vector<std::string>
  range_warnings<2>(const ModelRange::Record &, const std::vector<std::string> &, const Units &);
  template std::vector<std::string>
  range_warnings<3>(const ModelRange::Record &, const std::vector<std::string> &, const Units &);
} // namespace fuga
