// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/loads/uplift_way.h>

#include <algorithm>
#include <limits>
#include <map>

namespace fuga
{
  namespace
  {
    /** Return the corners of a face, a quadrilateral or a triangle, in their order along its edge.
     */
    std::vector<std::size_t>
    corners_in_turn(const std::size_t n_corners)
    {
      return n_corners == 4 ? std::vector<std::size_t>{0, 1, 3, 2}
                            : std::vector<std::size_t>{0, 1, 2};
    }
  } // namespace


  template <int dim>
  void
  UpliftWay<dim>::measure_in_space(const std::size_t way,
                                   const std::vector<std::vector<std::size_t>> &places)
  {
    if constexpr (dim == 3)
      {
        std::vector<std::size_t> faces;
        for (std::size_t f = 0; f < all_faces.size(); ++f)
          if (all_faces[f].way == way)
            faces.push_back(f);
        const auto &first = corners[faces.front()].front();
        double begin = first * flow, end = begin, size = 0.;
        for (const std::size_t f : faces)
          for (const auto &corner : corners[f])
            {
              begin = std::min(begin, corner * flow);
              end   = std::max(end, corner * flow);
              size  = std::max(size, corner.distance(first));
            }
        require_extent(way, end - begin, size);
        const auto across = direction_across(faces);
        for (const std::size_t f : faces)
          for (const auto &corner : corners[f])
            {
              all_faces[f].along.push_back((corner - first) * flow);
              all_faces[f].across.push_back((corner - first) * across);
            }
        all_ways[way].outline = outline_of(faces, places);
        measure_lines(way, faces);
      }
  }


  // A face that stands upright in the direction of flow is a step on the way. One that stands
  // upright beside it, or that lies upside down, shares its lines with others.
  template <int dim>
  dealii::Tensor<1, dim>
  UpliftWay<dim>::direction_across(const std::vector<std::size_t> &faces) const
  {
    dealii::Tensor<1, dim> across;
    if constexpr (dim == 3)
      {
        constexpr double upright = 1e-3;
        dealii::Tensor<1, dim> mean;
        for (const std::size_t f : faces)
          mean += all_faces[f].face->area * outward[f];
        mean -= (mean * flow) * flow;
        if (mean.norm() > 0.)
          mean /= mean.norm();
        for (const std::size_t f : faces)
          {
            const auto beside = outward[f] - (outward[f] * flow) * flow;
            if (beside.norm() > same_place && beside * mean <= upright * beside.norm())
              throw InputError(fmt::format(
                "{}: joint '{}' stands upright beside the flow of the water, or turns over, at "
                "({:g}), so that no line in the direction of flow ({}) belongs to it alone. Give "
                "this part a load of its own.",
                load_title(load),
                mesh.joints[all_faces[f].face->joint].name,
                fmt::join(&corners[f][0][0], &corners[f][0][0] + dim, ", "),
                flow_text()));
          }
        across = dealii::cross_product_3d(mean, flow);
      }
    return across;
  }


  // Where a face meets smaller ones the edges between them appear on both sides. They lie inside,
  // so that no line meets them first or last.
  template <int dim>
  PlanOutline
  UpliftWay<dim>::outline_of(const std::vector<std::size_t> &faces,
                             const std::vector<std::vector<std::size_t>> &places) const
  {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<PlanOutline::Edge>> edges;
    for (const std::size_t f : faces)
      {
        const auto points = corner_points(f);
        const auto turn   = corners_in_turn(points.size());
        for (std::size_t i = 0; i < turn.size(); ++i)
          {
            const std::size_t v = turn[i], w = turn[(i + 1) % turn.size()];
            edges[std::minmax(places[f][v], places[f][w])].push_back({{points[v], points[w]}});
          }
      }
    PlanOutline outline;
    for (const auto &[ends, copies] : edges)
      if (copies.size() == 1)
        outline.add(copies.front());
    return outline;
  }


  template <int dim>
  void
  UpliftWay<dim>::measure_lines(const std::size_t way, const std::vector<std::size_t> &faces)
  {
    Way &its = all_ways[way];
    std::vector<PlanOutline> parts;
    std::vector<double> borders;
    for (const std::size_t f : faces)
      parts.emplace_back(corner_points(f));
    for (const auto &edge : its.outline.edges())
      for (const PlanPoint &point : edge)
        borders.push_back(point.across);
    std::sort(borders.begin(), borders.end());
    const double narrow = same_place * (borders.back() - borders.front());
    its.shortest        = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
      if (borders[i + 1] - borders[i] > narrow)
        {
          const double middle   = (borders[i] + borders[i + 1]) / 2.;
          const WayOfWater here = line(way, middle);
          double covered        = 0.;
          for (const PlanOutline &part : parts)
            if (const auto inside = part.slice(middle))
              covered += (*inside)[1].along - (*inside)[0].along;
          if (covered < here.length() * (1. - same_place))
            throw InputError(fmt::format(
              "{}: lines in the direction of flow ({}) leave the joints {} and enter them again: "
              "they run {:g} through them, {:g} from end to end. Divide the joints so that each "
              "load has one upstream end.",
              load_title(load),
              flow_text(),
              joints_of(way),
              covered,
              here.length()));
          for (const WayOfWater &side :
               lines_through(way, {{0., borders[i], 0.}, {0., borders[i + 1], 0.}}))
            {
              its.shortest = std::min(its.shortest, side.length());
              its.longest  = std::max(its.longest, side.length());
            }
        }
  }


  template void
  UpliftWay<2>::measure_in_space(const std::size_t, const std::vector<std::vector<std::size_t>> &);
  template void
  UpliftWay<3>::measure_in_space(const std::size_t, const std::vector<std::vector<std::size_t>> &);
} // namespace fuga
