// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/joints/joint_order.h>
#include <fuga/bodies/point_matcher.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace fuga
{
  namespace
  {
    /** Ends of faces that are closer than this, relative to the length of a face, are one place. */
    constexpr double joined_share = 1e-5;

    /** Represents faces as edges of a graph whose nodes are places; edges are removed as they are
     * walked. */
    template <int dim>
    class Walker
    {
    public:
      explicit Walker(const std::vector<std::vector<dealii::Point<dim>>> &edges)
      {
        std::vector<dealii::Point<dim>> ends;
        for (const auto &edge : edges)
          ends.insert(ends.end(), edge.begin(), edge.end());
        const PointMatcher<dim> matcher(ends);
        for (unsigned int e = 0; e < edges.size(); ++e)
          {
            const double tolerance = joined_share * edges[e][0].distance(edges[e][1]);
            places.push_back(
              {{matcher.find(edges[e][0], tolerance), matcher.find(edges[e][1], tolerance)}});
            for (const unsigned int place : places.back())
              {
                edges_at[place].push_back(e);
                position[place] = ends[place];
                extent          = std::max(extent, ends[place].distance(ends.front()));
              }
          }
        walked.assign(edges.size(), false);
      }

      /** Return edge numbers in walking order, and whether each is walked backwards. */
      std::vector<std::pair<unsigned int, bool>>
      walk()
      {
        std::vector<std::pair<unsigned int, bool>> order;
        while (order.size() < walked.size())
          {
            unsigned int at = start();
            for (unsigned int e; (e = next_edge(at)) != PointMatcher<dim>::not_found;)
              {
                const bool backwards = places[e][0] != at;
                walked[e]            = true;
                order.emplace_back(e, backwards);
                at = places[e][backwards ? 0 : 1];
              }
          }
        return order;
      }

    private:
      unsigned int
      next_edge(const unsigned int place) const
      {
        for (const unsigned int e : edges_at.at(place))
          if (!walked[e])
            return e;
        return PointMatcher<dim>::not_found;
      }

      /** Return the first free end; in a closed line, the first place. */
      unsigned int
      start() const
      {
        unsigned int best       = PointMatcher<dim>::not_found;
        std::size_t best_degree = 0;
        for (const auto &[place, edges] : edges_at)
          {
            std::size_t degree = 0;
            for (const unsigned int e : edges)
              degree += walked[e] ? 0 : 1;
            const bool is_end = degree == 1, best_is_end = best_degree == 1;
            if (degree > 0 && (best_degree == 0 || (is_end && !best_is_end) ||
                               (is_end == best_is_end && is_before(place, best))))
              {
                best        = place;
                best_degree = degree;
              }
          }
        return best;
      }

      bool
      is_before(const unsigned int a, const unsigned int b) const
      {
        const auto offset = position.at(a) - position.at(b);
        for (unsigned int c = 0; c < dim; ++c)
          if (std::abs(offset[c]) > 1e-9 * extent)
            return offset[c] < 0.;
        return false;
      }

      std::vector<std::array<unsigned int, 2>> places;
      std::map<unsigned int, std::vector<unsigned int>> edges_at;
      std::map<unsigned int, dealii::Point<dim>> position;
      std::vector<bool> walked;
      double extent = 0.;
    };

    /** Order faces by their centers; coordinates that differ by less than a millionth of the joint
     * are equal. */
    std::vector<std::pair<unsigned int, bool>>
    order_of_centers(const std::vector<std::vector<dealii::Point<3>>> &faces)
    {
      dealii::Point<3> low = faces[0][0], high = low;
      for (const auto &face : faces)
        for (const auto &corner : face)
          for (unsigned int c = 0; c < 3; ++c)
            {
              low[c]  = std::min(low[c], corner[c]);
              high[c] = std::max(high[c], corner[c]);
            }
      const double unit = 1e-6 * low.distance(high);
      std::vector<std::pair<std::array<double, 3>, unsigned int>> keys;
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          dealii::Tensor<1, 3> center;
          for (const auto &corner : faces[i])
            center += (corner - low) / static_cast<double>(faces[i].size());
          keys.push_back({{{std::round(center[0] / unit),
                            std::round(center[1] / unit),
                            std::round(center[2] / unit)}},
                          i});
        }
      std::sort(keys.begin(), keys.end());
      std::vector<std::pair<unsigned int, bool>> order;
      for (const auto &key : keys)
        order.emplace_back(key.second, false);
      return order;
    }
  } // namespace


  template <int dim>
  std::vector<std::pair<unsigned int, bool>>
  joint_order(const std::vector<std::vector<dealii::Point<dim>>> &faces)
  {
    if (faces.empty())
      return {};
    if constexpr (dim == 2)
      return Walker<dim>(faces).walk();
    else
      return order_of_centers(faces);
  }


  template std::vector<std::pair<unsigned int, bool>>
  joint_order(const std::vector<std::vector<dealii::Point<2>>> &);
  template std::vector<std::pair<unsigned int, bool>>
  joint_order(const std::vector<std::vector<dealii::Point<3>>> &);
} // namespace fuga
