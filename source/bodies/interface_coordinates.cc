// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/disjoint_sets.h>
#include <fuga/bodies/interface_coordinates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace fuga
{
  namespace
  {
    constexpr int unset = std::numeric_limits<int>::max();

    /** Elements that share nodes, in the order of their first elements. */
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


  /** Collects the special rows; the coordinates get their final numbers afterwards. */
  template <int dim>
  class InterfaceCoordinates<dim>::Builder
  {
  public:
    Builder(const ContactBars<dim> &contact_bars,
            const std::vector<bool> &fixed_dofs,
            const Vector &node_stiffness,
            std::vector<int> &dof_rows,
            std::vector<std::pair<std::size_t, std::size_t>> &dof_hangs_on)
      : bars(contact_bars)
      , fixed(fixed_dofs)
      , stiffness(node_stiffness)
      , rows(dof_rows)
      , hangs_on(dof_hangs_on)
    {
      for (const auto &cluster : find_clusters(bars))
        if (cluster.size() == 1)
          add_pair(cluster.front());
        else
          add_junction(cluster);
    }

    DenseMatrix
    jump_operator() const
    {
      if (!has_junction)
        return {};
      DenseMatrix B(bars.bars().size(), n_interface);
      for (const auto &entry : jumps)
        B(entry.bar, entry.coordinate) += entry.factor;
      return B;
    }

    unsigned int n_interface                  = 0;
    unsigned int n_slides                     = 0;
    std::vector<std::vector<RawTerm>> special = {{}};

  private:
    struct JumpEntry
    {
      unsigned int bar, coordinate;
      double factor;
    };

    void
    set_row(const std::size_t dof, std::vector<RawTerm> terms)
    {
      rows[dof] = -1 - static_cast<int>(special.size());
      special.push_back(std::move(terms));
    }

    /** Two nodes: the softer one moves, or the one that is not held. */
    void
    add_pair(const unsigned int e)
    {
      const auto &element = bars.elements()[e];
      const auto &pair    = bars.pair_of_element(e);
      const RawTerm normal{Kind::interface, n_interface, 0.};
      std::vector<RawTerm> jump[dim];
      const auto add = [&](RawTerm term, const dealii::Tensor<1, dim> &direction) {
        for (unsigned int c = 0; c < dim; ++c)
          if (std::abs(direction[c]) > 1e-15)
            {
              term.factor = direction[c];
              jump[c].push_back(term);
            }
      };
      add(normal, pair.normal);
      jumps.push_back({element.normal_bar, n_interface++, 1.});
      const unsigned int tangential_bars[] = {element.tangential_bar,
                                              element.second_tangential_bar};
      for (unsigned int k = 0; k < bars.n_free_tangents(e); ++k)
        if (tangential_bars[k] != ContactElement::no_bar)
          {
            add({Kind::interface, n_interface, 0.}, bars.tangents_of_element(e)[k]);
            jumps.push_back({tangential_bars[k], n_interface++, 1.});
          }
        else
          add({Kind::slide, n_slides++, 0.}, bars.tangents_of_element(e)[k]);

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

    /** u of @p dof = u of @p base + sign * terms. */
    void
    attach(const std::size_t dof,
           const std::size_t base,
           std::vector<RawTerm> terms,
           const double sign)
    {
      for (auto &term : terms)
        term.factor *= sign;
      if (fixed[base])
        hangs_on.emplace_back(dof, base);
      else
        terms.push_back({Kind::dof, base, 1.});
      set_row(dof, std::move(terms));
    }

    /** Any number of nodes: offsets from one of them, a held or else the stiffest one, direction by
     * direction. */
    void
    add_junction(const std::vector<unsigned int> &cluster)
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
              offset[dof]                     = n_interface;
              const std::vector<RawTerm> term = {{Kind::interface, n_interface++, 1.}};
              if (obstacle)
                set_row(dof, term);
              else
                attach(dof, base, term, 1.);
            }
        }
      for (const unsigned int e : cluster)
        for (const unsigned int bar : {bars.elements()[e].normal_bar,
                                       bars.elements()[e].tangential_bar,
                                       bars.elements()[e].second_tangential_bar})
          if (bar != ContactElement::no_bar)
            add_jumps(bar, offset);
    }

    void
    add_jumps(const unsigned int number, const std::map<std::size_t, unsigned int> &offset)
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

    const ContactBars<dim> &bars;
    const std::vector<bool> &fixed;
    const Vector &stiffness;
    std::vector<int> &rows;
    std::vector<std::pair<std::size_t, std::size_t>> &hangs_on;
    std::vector<JumpEntry> jumps;
    bool has_junction = false;
  };


  template <int dim>
  InterfaceCoordinates<dim>::InterfaceCoordinates(const Discretization<dim> &discretization,
                                                  const ContactBars<dim> &bars,
                                                  const std::vector<bool> &fixed,
                                                  const Vector &stiffness)
    : rows(discretization.n_dofs(), unset), hanging(discretization.hanging_nodes())
  {
    for (const auto &entry : hanging.masters())
      for (unsigned int c = 0; c < dim; ++c)
        rows[entry.first * dim + c] = -1; // until add_hanging_nodes()
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (fixed[dof])
        rows[dof] = -1;
    const Builder builder(bars, fixed, stiffness, rows, hangs_on);
    interface_count = builder.n_interface;
    number(builder);
    add_hanging_nodes(fixed);
    B = builder.jump_operator();
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::number(const Builder &builder)
  {
    unsigned int count = 0;
    for (int &row : rows)
      if (row == unset)
        row = static_cast<int>(count++);
    const unsigned int first_slide = count, first_interface = count + builder.n_slides;
    n_coordinates = first_interface + interface_count;

    special.resize(builder.special.size());
    for (std::size_t i = 0; i < special.size(); ++i)
      for (const RawTerm &term : builder.special[i])
        {
          unsigned int coordinate = static_cast<unsigned int>(term.index);
          if (term.kind == Kind::interface)
            coordinate += first_interface;
          else if (term.kind == Kind::slide)
            coordinate += first_slide;
          else
            coordinate = plain_coordinate(term.index);
          special[i].push_back({coordinate, term.factor});
        }
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::add_hanging_nodes(const std::vector<bool> &fixed)
  {
    std::vector<Term> of_master;
    for (const auto &[node, masters] : hanging.masters())
      for (unsigned int c = 0; c < dim; ++c)
        {
          if (fixed[node * dim + c])
            continue;
          std::map<unsigned int, double> sum;
          for (const auto &[master, weight] : masters)
            {
              terms_of(master * dim + c, of_master);
              for (const Term &term : of_master)
                sum[term.coordinate] += weight * term.factor;
            }
          rows[node * dim + c] = -1 - static_cast<int>(special.size());
          special.emplace_back();
          for (const auto &[coordinate, factor] : sum)
            special.back().push_back({coordinate, factor});
        }
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::terms_of(const std::size_t dof, std::vector<Term> &terms) const
  {
    terms.clear();
    if (rows[dof] >= 0)
      terms.push_back({plain_coordinate(dof), 1.});
    else
      terms = special[static_cast<std::size_t>(-1 - rows[dof])];
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::distribute(const double *y, const Vector &prescribed) const
  {
    Vector u = prescribed.empty() ? Vector(rows.size(), 0.) : prescribed;
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (rows[dof] >= 0)
        u[dof] += y[rows[dof]];
      else
        for (const Term &term : special[static_cast<std::size_t>(-1 - rows[dof])])
          u[dof] += term.factor * y[term.coordinate];
    return u;
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::gather(const Vector &forces) const
  {
    Vector result(n_coordinates, 0.);
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (rows[dof] >= 0)
        result[plain_coordinate(dof)] += forces[dof];
      else
        for (const Term &term : special[static_cast<std::size_t>(-1 - rows[dof])])
          result[term.coordinate] += term.factor * forces[dof];
    return result;
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::extend_prescribed(Vector &prescribed) const
  {
    for (const auto &[dof, support] : hangs_on)
      prescribed[dof] = prescribed[support];
    hanging.follow_masters(prescribed);
  }


  template class InterfaceCoordinates<2>;
  template class InterfaceCoordinates<3>;
} // namespace fuga
