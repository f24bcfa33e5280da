// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/loads/joint_water_model.h>
#include <fuga/bodies/point_matcher.h>
#include <fuga/bodies/space/node_cells_on_face.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Share of a way that counts as its end. */
    constexpr double at_end = 1e-9;

    void
    connect_elements(const std::size_t k, const std::size_t l, WaterNetwork &network)
    {
      if (k == l)
        return;
      for (const auto &[from, to] : {std::pair(k, l), std::pair(l, k)})
        {
          auto &neighbours = network.neighbours[from];
          if (std::find(neighbours.begin(), neighbours.end(), to) == neighbours.end())
            neighbours.push_back(to);
        }
    }
  } // namespace

  template <int dim>
  JointWaterModel<dim>::JointWaterModel(const Assemblies &its_assemblies,
                                        const std::vector<LoadPattern> &its_patterns,
                                        const ModelDefinition &model,
                                        const Discretization<dim> &space,
                                        const ContactBars<dim> &contact_bars)
    : assemblies(its_assemblies), patterns(its_patterns), discretization(space), bars(contact_bars)
  {
    const std::size_t n = bars.elements().size();
    its_network.neighbours.resize(n);
    its_network.wet = its_network.upstream = its_network.downstream = std::vector<bool>(n, false);
    std::vector<dealii::Point<dim>> positions;
    for (std::size_t i = 0; i < assemblies.size(); ++i)
      if (assemblies[i] && model.loads[i].uplift.fills_cracks)
        connect(*assemblies[i]);
    for (std::size_t k = 0; k < n; ++k)
      positions.push_back(bars.pair_of_element(k).position);

    // Several elements lie at one place where joints cross or meet, and at their corners.
    double size = 0.;
    for (const auto &position : positions)
      size = std::max(size, position.distance(positions.front()));
    const PointMatcher<dim> matcher(positions);
    std::vector<std::vector<std::size_t>> at_place(n);
    for (std::size_t k = 0; k < n; ++k)
      if (its_network.wet[k])
        {
          const std::size_t place = matcher.find(positions[k], one_node * size);
          for (const std::size_t other : at_place[place])
            connect_elements(k, other, its_network);
          at_place[place].push_back(k);
        }
  }


  template <int dim>
  bool
  JointWaterModel<dim>::is_needed(const std::vector<LoadPattern> &patterns)
  {
    return std::any_of(patterns.begin(), patterns.end(), [](const LoadPattern &pattern) {
      return !pattern.opening_water.empty();
    });
  }


  // An end without an element (where supports hold both sides, for example) is that of the elements
  // next to it.
  template <int dim>
  void
  JointWaterModel<dim>::connect(const UpliftAssembly<dim> &assembly)
  {
    const unsigned int degree = discretization.reference_element().scalar_element().degree;
    for (const auto &face : assembly.way().faces())
      {
        const std::size_t n_corners = face.along.size();
        const auto cells            = node_cells_on_face<dim>(n_corners, degree);
        const FaceMap<dim> map(discretization, face.face->boundary);
        const UpliftWay<dim> &way = assembly.way();
        const double tolerance    = at_end * way.ways()[face.way].longest;
        std::vector<typename ContactBars<dim>::Shares> elements;
        for (std::size_t k = 0; k < cells.size(); ++k)
          elements.push_back(bars.shares_of_pair(face.face->pair_of_node(k)));

        std::vector<bool> at_upstream, at_downstream;
        for (const auto &cell : cells)
          {
            bool up = false, down = false;
            const auto points = way.points(face, map, cell);
            const auto lines  = way.lines_through(face.way, points);
            for (std::size_t i = 0; i < points.size(); ++i)
              {
                up |= points[i].along <= lines[i].begin + tolerance;
                down |= points[i].along >= lines[i].end - tolerance;
              }
            at_upstream.push_back(up);
            at_downstream.push_back(down);
          }
        const auto mark_end = [&](const std::vector<bool> &at, std::vector<bool> &marks) {
          bool any = false;
          for (std::size_t k = 0; k < cells.size(); ++k)
            for (const auto &share : elements[k])
              if (at[k])
                {
                  marks[share.first] = true;
                  any                = true;
                }
          const bool lies_there = std::find(at.begin(), at.end(), true) != at.end();
          for (std::size_t k = 0; lies_there && !any && k < cells.size(); ++k)
            for (const auto &share : elements[k])
              marks[share.first] = true;
        };
        mark_end(at_upstream, its_network.upstream);
        mark_end(at_downstream, its_network.downstream);
        for (const auto &shares : elements)
          for (const auto &share : shares)
            its_network.wet[share.first] = true;
        for (const auto &[k, l] : neighbours_on_face(dim, n_corners, degree))
          for (const auto &a : elements[k])
            for (const auto &b : elements[l])
              connect_elements(a.first, b.first, its_network);
      }
  }


  template <int dim>
  auto
  JointWaterModel<dim>::known_forces(const std::vector<WaterAccess> &access,
                                     const Vector &factors) const -> const Known &
  {
    if (memory[last_used].access != access)
      last_used = 1 - last_used;
    Known &known = memory[last_used];
    if (known.access != access)
      {
        known.access = access;
        known.columns.assign(patterns.size(), Vector());
      }
    // Patterns of one load are assembled together, since they share the data of its lines.
    for (std::size_t i = 0; i < assemblies.size(); ++i)
      {
        std::vector<std::size_t> wanted;
        std::vector<WaterLevels> levels;
        for (std::size_t j = 0; j < patterns.size(); ++j)
          if (factors[j] != 0. && known.columns[j].empty() && patterns[j].number_of_load == i &&
              !patterns[j].opening_water.empty())
            {
              wanted.push_back(j);
              levels.push_back(patterns[j].levels);
            }
        if (wanted.empty())
          continue;
        std::vector<Vector> columns = assemblies[i]->forces(access, levels);
        for (std::size_t c = 0; c < wanted.size(); ++c)
          {
            const Vector &closed = patterns[wanted[c]].closed_water;
            for (std::size_t bar = 0; bar < closed.size(); ++bar)
              columns[c][bar] -= closed[bar];
            known.columns[wanted[c]] = std::move(columns[c]);
          }
      }
    return known;
  }


  template <int dim>
  Vector
  JointWaterModel<dim>::forces(const std::vector<WaterAccess> &access, const Vector &factors) const
  {
    Vector result(bars.bars().size(), 0.);
    if (std::all_of(access.begin(), access.end(), [](const WaterAccess a) {
          return a == WaterAccess::seepage || a == WaterAccess::isolated;
        }))
      return result;
    const Known &known = known_forces(access, factors);
    for (std::size_t j = 0; j < known.columns.size(); ++j)
      if (factors[j] != 0. && !known.columns[j].empty())
        for (std::size_t bar = 0; bar < result.size(); ++bar)
          result[bar] += factors[j] * known.columns[j][bar];
    return result;
  }


  template class JointWaterModel<2>;
  template class JointWaterModel<3>;
} // namespace fuga
