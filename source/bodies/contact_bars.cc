// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/contact_bars.h>

#include <cmath>
#include <map>

namespace fuga
{
  namespace
  {
    /** A support counts as aligned with the frame of a joint up to this sine. */
    constexpr double alignment_tolerance = 1e-10;

    /** How many node pairs every node belongs to: more than one where joints cross or touch. */
    template <int dim>
    std::map<unsigned int, unsigned int>
    count_pairs(const std::vector<NodePair<dim>> &pairs)
    {
      std::map<unsigned int, unsigned int> result;
      for (const auto &pair : pairs)
        for (const unsigned int node : {pair.plus_node, pair.minus_node})
          ++result[node];
      result.erase(Discretization<dim>::no_node);
      return result;
    }
  } // namespace


  template <int dim>
  ContactBars<dim>::ContactBars(const JointGeometry<dim> &joint_geometry,
                                const JointedMesh &mesh,
                                const std::vector<bool> &fixed,
                                const std::vector<bool> &frictionless)
    : geometry(joint_geometry), pair_elements(geometry.pairs().size(), no_element)
  {
    std::vector<unsigned int> count(mesh.joints.size(), 0), left_out(mesh.joints.size(), 0);
    const std::map<unsigned int, unsigned int> n_pairs = count_pairs<dim>(geometry.pairs());
    for (unsigned int i = 0; i < geometry.pairs().size(); ++i)
      {
        const auto &pair = geometry.pairs()[i];
        if (pair.plus_node == pair.minus_node)
          continue; // the tip of a joint inside a body
        if (pair.area == 0.)
          {
            lines.push_back(
              fmt::format("joint '{}': the node pair on the axis has no area and carries "
                          "no element",
                          mesh.joints[pair.joint].name));
            continue;
          }
        const Jump jump = possible_jump(pair, mesh.joints[pair.joint].name, fixed);
        if (jump == Jump::none)
          {
            ++left_out[pair.joint];
            continue;
          }
        no_tangential_jump.push_back(jump == Jump::normal_only);
        // Where joints cross, the jumps of all bars determine the motion: none may be missing.
        const bool crossing =
          n_pairs.at(pair.plus_node) > 1 ||
          (pair.minus_node != Discretization<dim>::no_node && n_pairs.at(pair.minus_node) > 1);
        add_element(
          i, count[pair.joint]++, jump == Jump::free && (!frictionless[pair.joint] || crossing));
      }
    for (std::size_t joint = 0; joint < left_out.size(); ++joint)
      if (left_out[joint] > 0)
        lines.push_back(fmt::format("joint '{}': {} node pair(s) held by supports carry no element",
                                    mesh.joints[joint].name,
                                    left_out[joint]));
  }


  template <int dim>
  typename ContactBars<dim>::Jump
  ContactBars<dim>::possible_jump(const NodePair<dim> &pair,
                                  const std::string &joint,
                                  const std::vector<bool> &fixed)
  {
    const bool obstacle = pair.minus_node == Discretization<dim>::no_node;
    unsigned int n_held = 0, held = 0;
    for (unsigned int c = 0; c < dim; ++c)
      if (fixed[pair.plus_node * dim + c] && (obstacle || fixed[pair.minus_node * dim + c]))
        {
          all_held_pairs.push_back({pair.plus_node, pair.minus_node, c});
          ++n_held;
          held = c;
        }
    if (n_held == 0)
      return Jump::free;
    if (n_held == dim || std::abs(tangent(pair.normal)[held]) < alignment_tolerance)
      return Jump::none;
    if (std::abs(pair.normal[held]) < alignment_tolerance)
      return Jump::normal_only;
    throw InputError(fmt::format(
      "Joint '{}' at ({:g}, {:g}): both sides are held in {} only, which is oblique to the joint's "
      "normal ({:g}, {:g}). Hold both components there or none, or end the joint a little before.",
      joint,
      pair.position[0],
      pair.position[1],
      "xyz"[held],
      pair.normal[0],
      pair.normal[1]));
  }


  template <int dim>
  void
  ContactBars<dim>::add_element(const unsigned int index,
                                const unsigned int number,
                                const bool tangential_bar)
  {
    const auto &pair = geometry.pairs()[index];
    ContactElement element;
    element.joint  = pair.joint;
    element.number = number;
    element.area   = pair.area;
    for (unsigned int c = 0; c < dim; ++c)
      element.position[c] = pair.position[c];

    element.normal_bar = static_cast<unsigned int>(all_bars.size());
    all_bars.push_back({pair.plus_node, pair.minus_node, pair.normal});
    if (tangential_bar)
      {
        element.tangential_bar = static_cast<unsigned int>(all_bars.size());
        all_bars.push_back({pair.plus_node, pair.minus_node, tangent(pair.normal)});
      }
    pair_elements[index] = static_cast<unsigned int>(all_elements.size());
    pairs.push_back(index);
    all_elements.push_back(element);
  }


  template <int dim>
  Vector
  ContactBars<dim>::jumps(const Vector &u) const
  {
    Vector result(all_bars.size(), 0.);
    for (std::size_t i = 0; i < all_bars.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const Bar &bar = all_bars[i];
          result[i] += bar.direction[c] * u[bar.plus_node * dim + c];
          if (bar.minus_node != Discretization<dim>::no_node)
            result[i] -= bar.direction[c] * u[bar.minus_node * dim + c];
        }
    return result;
  }


  template <int dim>
  void
  ContactBars<dim>::add_forces(const double factor, const Vector &p, Vector &forces) const
  {
    for (std::size_t i = 0; i < all_bars.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const Bar &bar     = all_bars[i];
          const double force = factor * p[i] * bar.direction[c];
          forces[bar.plus_node * dim + c] += force;
          if (bar.minus_node != Discretization<dim>::no_node)
            forces[bar.minus_node * dim + c] -= force;
        }
  }


  template class ContactBars<2>;
} // namespace fuga
