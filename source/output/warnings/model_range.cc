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
    enum Kind
    {
      normal_table,
      shear_table,
      slip,
      turn,
      n_kinds
    };

    /** Of the length of a joint: lips that slip by more do not lie opposite to each other. */
    constexpr double largest_slip = 0.05;

    /** Behind it the cosine of a rotation is not 1. */
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

    std::vector<double>
    lengths_of_joints(const std::vector<ContactElement> &elements, const std::size_t n_joints)
    {
      std::vector<double> squares(n_joints, 0.);
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
      std::transform(
        squares.begin(), squares.end(), squares.begin(), [](double x) { return std::sqrt(x); });
      return squares;
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
    sentence(const int kind, const ModelExcess &excess, const Units &units)
    {
      switch (kind)
        {
          case slip:
            return fmt::format("{} slips by {:.4g} {} at t = {:.6g}, {:.2g} times the length of "
                               "the joint. Lips are taken to stay opposite to each other, which "
                               "is meant for less than {:g} times.",
                               place_of<dim>(excess),
                               excess.largest,
                               units.length,
                               excess.t,
                               excess.largest / excess.limit,
                               largest_slip);
          case turn:
            return fmt::format("openings differ by {:.4g} {} at t = {:.6g}, {:.2g} times the "
                               "length of the joint: bodies turn by about that angle. "
                               "Displacements are taken for small, which is meant for less than "
                               "{:g}.",
                               excess.largest,
                               units.length,
                               excess.t,
                               excess.largest / excess.limit,
                               largest_turn);
          default:
            return fmt::format("the {} table ends at {:g} {}, but {} reaches {:.6g} at t = {:.6g}. "
                               "Beyond its last point the table is continued by a straight line: "
                               "add points.",
                               kind == normal_table ? "normal" : "shear",
                               excess.limit,
                               units.stress(),
                               place_of<dim>(excess),
                               excess.largest,
                               excess.t);
        }
    }
  } // namespace

  ModelRange::ModelRange(const std::vector<ContactElement> &contact_elements,
                         const std::size_t n_joints,
                         Record &record_of_run)
    : elements(contact_elements)
    , lengths(lengths_of_joints(elements, n_joints))
    , record(record_of_run)
  {
    record.resize(n_joints * n_kinds);
  }

  void
  ModelRange::watch(const JointState &state)
  {
    std::vector<double> least(lengths.size(), std::numeric_limits<double>::infinity());
    std::vector<const ContactElement *> widest(lengths.size(), nullptr);
    std::vector<double> most(lengths.size(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const unsigned int joint      = element.joint;
        watch_table(element, state, true);
        if (element.has_tangential_bar())
          watch_table(element, state, false);
        if (const double way = length(state.slips[k]); way > largest_slip * lengths[joint])
          note(record[joint * n_kinds + slip], way, lengths[joint], state.t, element);
        const double opening = state.states[k] == ContactState::open
                                 ? element.initial_gap + state.dislocations[element.normal_bar]
                                 : 0.;
        least[joint]         = std::min(least[joint], opening);
        if (widest[joint] == nullptr || opening > most[joint])
          {
            widest[joint] = &element;
            most[joint]   = opening;
          }
      }
    for (std::size_t joint = 0; joint < lengths.size(); ++joint)
      if (most[joint] - least[joint] > largest_turn * lengths[joint])
        note(record[joint * n_kinds + turn],
             most[joint] - least[joint],
             lengths[joint],
             state.t,
             *widest[joint]);
  }

  void
  ModelRange::watch_table(const ContactElement &element, const JointState &state, const bool normal)
  {
    const ComplianceLaw &law = normal ? *element.normal_law : *element.shear_law;
    if (!std::isfinite(law.data_limit()))
      return;
    const double end    = law.stress(law.data_limit());
    const double force  = state.forces[normal ? element.normal_bar : element.tangential_bar];
    const double stress = (normal ? -force : std::abs(force)) / element.area;
    if (stress > end)
      note(record[element.joint * n_kinds + (normal ? normal_table : shear_table)],
           stress,
           end,
           state.t,
           element);
  }

  template <int dim>
  std::vector<std::string>
  range_warnings(const ModelRange::Record &record,
                 const std::vector<std::string> &joint_names,
                 const Units &units)
  {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < record.size(); ++i)
      if (record[i].largest > 0.)
        result.push_back(
          fmt::format("joint '{}': {}",
                      joint_names[i / n_kinds],
                      sentence<dim>(static_cast<int>(i % n_kinds), record[i], units)));
    return result;
  }

  template std::vector<std::string>
  range_warnings<2>(const ModelRange::Record &, const std::vector<std::string> &, const Units &);
  template std::vector<std::string>
  range_warnings<3>(const ModelRange::Record &, const std::vector<std::string> &, const Units &);
} // namespace fuga
