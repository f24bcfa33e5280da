// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/disjoint_sets.h>
#include <fuga/bodies/joints/interface_rows.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Length of the remainder of a unit vector that counts as a direction of its own. */
    constexpr double smallest_rest = 1e-10;

    /** Return a cosine, rounded to a whole number if it differs from one only by rounding. */
    double
    without_rounding(const double cosine)
    {
      constexpr double rounding = 1e-14;
      const double whole        = std::round(cosine);
      return std::abs(cosine - whole) < rounding ? whole : cosine;
    }

    /** Return the sets of elements that share nodes, in the order of their first elements. */
    template <int dim>
    std::vector<std::vector<unsigned int>>
    find_clusters(const ContactBars<dim> &bars)
    {
      const std::size_t n = bars.elements().size();
      DisjointSets sets(n);
      std::map<unsigned int, unsigned int> first_element;
      for (unsigned int e = 0; e < n; ++e)
        for (const unsigned int node :
             {bars.pair_of_element(e).plus_node, bars.pair_of_element(e).minus_node})
          if (node != Discretization<dim>::no_node)
            sets.unite(e, first_element.try_emplace(node, e).first->second);
      std::vector<unsigned int> numbers;
      std::vector<std::vector<unsigned int>> clusters(sets.number(numbers));
      for (unsigned int e = 0; e < n; ++e)
        clusters[numbers[e]].push_back(e);
      return clusters;
    }
  } // namespace


  template <int dim>
  InterfaceRows<dim>::InterfaceRows(const ContactBars<dim> &contact_bars,
                                    const std::vector<bool> &fixed_dofs,
                                    const Vector &node_stiffness,
                                    dealii::AffineConstraints<double> &its_constraints)
    : bars(contact_bars), fixed(fixed_dofs), stiffness(node_stiffness), constraints(its_constraints)
  {
    for (const auto &cluster : find_clusters(bars))
      if (is_pair(cluster))
        add_pair(cluster);
      else
        add_junction(cluster);
  }


  template <int dim>
  SparseOperator
  InterfaceRows<dim>::jump_operator() const
  {
    if (!has_junction)
      return {};
    return {bars.bars().size(), interface_count, jumps};
  }


  template <int dim>
  bool
  InterfaceRows<dim>::is_pair(const Cluster &cluster) const
  {
    const auto &first = bars.pair_of_element(cluster.front());
    return std::all_of(cluster.begin(), cluster.end(), [&](const unsigned int e) {
      const auto &pair = bars.pair_of_element(e);
      return pair.plus_node == first.plus_node && pair.minus_node == first.minus_node;
    });
  }


  // Of two nodes the softer one moves, or the one that is not held.
  template <int dim>
  void
  InterfaceRows<dim>::add_pair(const Cluster &cluster)
  {
    Terms jump[dim];
    for (const LocalDirection &local : frame_of_jumps(cluster))
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(local.direction[c]) > 1e-15)
          jump[c].emplace_back(local.unknown, local.direction[c]);

    const auto &pair      = bars.pair_of_element(cluster.front());
    const bool obstacle   = pair.minus_node == Discretization<dim>::no_node;
    const bool plus_moves = obstacle || stiffness[pair.plus_node] <= stiffness[pair.minus_node];
    for (unsigned int c = 0; c < dim; ++c)
      {
        const std::size_t plus = pair.plus_node * dim + c, minus = pair.minus_node * dim + c;
        if (obstacle && !fixed[plus])
          set_row(plus, jump[c]);
        else if (!obstacle && !fixed[plus] && (plus_moves || fixed[minus]))
          attach(plus, minus, std::move(jump[c]), 1.);
        else if (!obstacle && !fixed[minus])
          attach(minus, plus, std::move(jump[c]), -1.);
      }
  }


  // The frame consists first of the bars of the first element, at a corner also of the directions
  // that those of the others add, and last, where there is no bar, of slides.
  template <int dim>
  auto
  InterfaceRows<dim>::frame_of_jumps(const Cluster &cluster) -> std::vector<LocalDirection>
  {
    std::vector<LocalDirection> frame;
    for (const unsigned int e : cluster)
      for (const unsigned int bar : bars_of(e))
        {
          add_direction(bars.bars()[bar].direction, true, frame);
          for (const LocalDirection &local : frame)
            if (const double factor =
                  without_rounding(local.direction * bars.bars()[bar].direction);
                factor != 0.)
              jumps.push_back({bar, local.coordinate, factor});
        }
    for (const unsigned int e : cluster)
      for (unsigned int k = 0; k < bars.n_free_tangents(e); ++k)
        add_direction(bars.tangents_of_element(e)[k], false, frame);
    has_junction |= cluster.size() > 1;
    return frame;
  }


  template <int dim>
  void
  InterfaceRows<dim>::add_direction(dealii::Tensor<1, dim> direction,
                                    const bool by_bar,
                                    std::vector<LocalDirection> &frame)
  {
    for (const LocalDirection &local : frame)
      direction -= without_rounding(direction * local.direction) * local.direction;
    const double size = without_rounding(direction.norm());
    if (size < smallest_rest)
      return;
    const unsigned int coordinate = interface_count;
    frame.push_back({direction / size, new_jump(by_bar), coordinate});
  }


  template <int dim>
  dealii::types::global_dof_index
  InterfaceRows<dim>::new_jump(const bool by_bar)
  {
    jump_has_bar.push_back(by_bar);
    interface_count += by_bar ? 1 : 0;
    return static_cast<dealii::types::global_dof_index>(fixed.size() + jump_has_bar.size() - 1);
  }


  template <int dim>
  std::vector<unsigned int>
  InterfaceRows<dim>::bars_of(const unsigned int e) const
  {
    const auto &element              = bars.elements()[e];
    std::vector<unsigned int> result = {element.normal_bar};
    for (const unsigned int bar : {element.tangential_bar, element.second_tangential_bar})
      if (bar != ContactElement::no_bar)
        result.push_back(bar);
    return result;
  }


  template <int dim>
  void
  InterfaceRows<dim>::set_row(const std::size_t dof, const Terms &terms)
  {
    constraints.add_line(static_cast<unsigned int>(dof));
    constraints.add_entries(static_cast<unsigned int>(dof), terms);
  }


  template <int dim>
  void
  InterfaceRows<dim>::attach(const std::size_t dof,
                             const std::size_t base,
                             Terms terms,
                             const double sign)
  {
    for (auto &term : terms)
      term.second *= sign;
    terms.emplace_back(static_cast<dealii::types::global_dof_index>(base), 1.);
    set_row(dof, terms);
  }


  // A junction has any number of nodes. They get offsets from one of them, a held or else the
  // stiffest one, direction by direction.
  template <int dim>
  void
  InterfaceRows<dim>::add_junction(const Cluster &cluster)
  {
    has_junction = true;
    std::vector<std::size_t> nodes;
    bool obstacle = false;
    for (const unsigned int e : cluster)
      for (const unsigned int node :
           {bars.pair_of_element(e).plus_node, bars.pair_of_element(e).minus_node})
        if (node == Discretization<dim>::no_node)
          obstacle = true;
        else if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
          nodes.push_back(node);

    const auto less_stiff = [this](const std::size_t a, const std::size_t b) {
      return stiffness[a] < stiffness[b];
    };
    std::map<std::size_t, unsigned int> offset; // dof -> interface coordinate
    for (unsigned int c = 0; c < dim; ++c)
      {
        std::size_t base = *std::max_element(nodes.begin(), nodes.end(), less_stiff) * dim + c;
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
          if (fixed[*node * dim + c])
            base = *node * dim + c;
        for (const std::size_t node : nodes)
          {
            const std::size_t dof = node * dim + c;
            if (fixed[dof] || (dof == base && !obstacle))
              continue;
            offset[dof]      = interface_count;
            const Terms term = {{new_jump(true), 1.}};
            if (obstacle)
              set_row(dof, term);
            else
              attach(dof, base, term, 1.);
          }
      }
    for (const unsigned int e : cluster)
      for (const unsigned int bar : bars_of(e))
        add_jumps(bar, offset);
  }


  template <int dim>
  void
  InterfaceRows<dim>::add_jumps(const unsigned int number,
                                const std::map<std::size_t, unsigned int> &offset)
  {
    const auto &bar = bars.bars()[number];
    for (unsigned int c = 0; c < dim; ++c)
      for (const double sign : {1., -1.})
        {
          const unsigned int node = sign > 0. ? bar.plus_node : bar.minus_node;
          if (node == Discretization<dim>::no_node)
            continue;
          const auto entry = offset.find(node * dim + c);
          if (entry != offset.end())
            jumps.push_back({number, entry->second, sign * bar.direction[c]});
        }
  }


  template class InterfaceRows<2>;
  template class InterfaceRows<3>;
} // namespace fuga
