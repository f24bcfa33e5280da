// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/point_text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fuga
{
  namespace
  {
    /** Sine of the angle up to which a support counts as aligned with the frame of a joint. */
    constexpr double alignment_tolerance = 1e-10;

    /** Return how many nodes each node faces: more than one where joints cross or touch. */
    template <int dim>
    std::map<unsigned int, std::size_t>
    count_partners(const std::vector<NodePair<dim>> &pairs)
    {
      std::map<unsigned int, std::set<unsigned int>> partners;
      for (const auto &pair : pairs)
        {
          partners[pair.plus_node].insert(pair.minus_node);
          partners[pair.minus_node].insert(pair.plus_node);
        }
      std::map<unsigned int, std::size_t> result;
      for (const auto &[node, of_node] : partners)
        result[node] = node == Discretization<dim>::no_node ? 0 : of_node.size();
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
    const std::map<unsigned int, std::size_t> n_partners = count_partners<dim>(geometry.pairs());
    for (unsigned int i = 0; i < geometry.pairs().size(); ++i)
      {
        const auto &pair = geometry.pairs()[i];
        if (pair.plus_node == pair.minus_node || !pair.masters.empty())
          continue; // the tip of a joint inside a body; a pair that hangs
        if (pair.area == 0.)
          {
            lines.push_back(
              fmt::format("joint '{}': the node pair on the axis has no area and carries "
                          "no element",
                          mesh.joints[pair.joint].name));
            continue;
          }
        const Jump jump = possible_jump(pair, mesh.joints[pair.joint].name, fixed);
        if (!jump.normal)
          {
            ++left_out[pair.joint];
            continue;
          }
        // Where joints cross, the jumps of all bars determine the motion, so that none may be
        // missing.
        const bool crossing =
          n_partners.at(pair.plus_node) > 1 || n_partners.at(pair.minus_node) > 1;
        add_element(i, count[pair.joint]++, jump, !frictionless[pair.joint] || crossing);
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
    std::vector<unsigned int> held;
    for (unsigned int c = 0; c < dim; ++c)
      if (fixed[pair.plus_node * dim + c] && (obstacle || fixed[pair.minus_node * dim + c]))
        {
          all_held_pairs.push_back({pair.plus_node, pair.minus_node, c});
          held.push_back(c);
        }
    Jump jump;
    jump.tangents = tangents(pair.normal);
    if (held.empty())
      return jump;
    double largest_held = 0., largest_free = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      {
        const bool is_held = std::find(held.begin(), held.end(), c) != held.end();
        double &largest    = is_held ? largest_held : largest_free;
        largest            = std::max(largest, std::abs(pair.normal[c]));
      }
    jump.normal = largest_free > alignment_tolerance;
    if (!jump.normal)
      return jump;
    if (largest_held >= alignment_tolerance)
      throw InputError(fmt::format(
        "Joint '{}' at {}: both sides are held in {} only, which is oblique to the joint's normal "
        "{}. Hold all components there or none, or end the joint a little before.",
        joint,
        text_of(pair.position),
        "xyz"[held.front()],
        text_of(pair.normal)));
    jump.n_free_tangents = dim - 1 - static_cast<unsigned int>(held.size());
    // A joint along a held axis has that axis as a tangent; it is the second tangent, or becomes
    // it.
    if constexpr (dim == 3)
      if (jump.n_free_tangents == 1 &&
          std::abs(jump.tangents[0][held.front()]) > alignment_tolerance)
        jump.tangents = {{jump.tangents[1], -jump.tangents[0]}};
    return jump;
  }


  template <int dim>
  void
  ContactBars<dim>::add_element(const unsigned int index,
                                const unsigned int number,
                                const Jump &jump,
                                const bool tangential_bars)
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
    unsigned int *const numbers[] = {&element.tangential_bar, &element.second_tangential_bar};
    for (unsigned int k = 0; tangential_bars && k < jump.n_free_tangents; ++k)
      {
        *numbers[k] = static_cast<unsigned int>(all_bars.size());
        all_bars.push_back({pair.plus_node, pair.minus_node, jump.tangents[k]});
      }
    pair_elements[index] = static_cast<unsigned int>(all_elements.size());
    pairs.push_back(index);
    its_tangents.push_back(jump.tangents);
    free_tangents.push_back(jump.n_free_tangents);
    all_elements.push_back(element);
  }


  template <int dim>
  typename ContactBars<dim>::Shares
  ContactBars<dim>::shares_of_pair(const unsigned int pair) const
  {
    if (pair_elements[pair] != no_element)
      return {{pair_elements[pair], 1.}};
    Shares shares;
    for (const auto &[master, weight] : geometry.pairs()[pair].masters)
      if (pair_elements[master] != no_element)
        shares.emplace_back(pair_elements[master], weight);
    return shares;
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
  template class ContactBars<3>;
} // namespace fuga
