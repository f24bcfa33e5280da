// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/loads/uplift_way.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/point_matcher.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  template <int dim>
  UpliftWay<dim>::UpliftWay(const LoadDefinition &its_load,
                            const Discretization<dim> &discretization,
                            const JointGeometry<dim> &geometry,
                            const JointedMesh &jointed)
    : load(its_load), mesh(jointed)
  {
    for (unsigned int c = 0; c < dim; ++c)
      flow[c] = load.uplift.flow[c];
    for (const auto &face : geometry.faces())
      if (index_of(load.targets, mesh.joints[face.joint].name) < load.targets.size())
        {
          all_faces.push_back({&face, 0, {}, {}});
          const FaceMap<dim> map(discretization, face.boundary);
          corners.push_back(map.corners());
          outward.push_back(map.normal(
            discretization.reference_element().face(face.boundary.number).corner_points.front()));
        }
    // Copies of one node lie at one place, which is identified by the first corner there.
    std::vector<dealii::Point<dim>> points;
    double size = 0.;
    for (const auto &of_face : corners)
      for (const auto &corner : of_face)
        {
          points.push_back(corner);
          size = std::max(size, corner.distance(points.front()));
        }
    const PointMatcher<dim> matcher(points);
    std::vector<std::vector<std::size_t>> places;
    for (const auto &of_face : corners)
      {
        places.emplace_back();
        for (const auto &corner : of_face)
          places.back().push_back(matcher.find(corner, one_node * size));
      }
    find_ways(places);
    for (std::size_t way = 0; way < all_ways.size(); ++way)
      {
        if constexpr (dim == 2)
          measure_chain(way, places, points);
        else
          measure_in_space(way, places);
        check_drain(way);
      }
  }


  template <int dim>
  void
  UpliftWay<dim>::find_ways(const std::vector<std::vector<std::size_t>> &places)
  {
    std::vector<std::vector<std::size_t>> faces_at_place;
    for (std::size_t f = 0; f < places.size(); ++f)
      for (const std::size_t place : places[f])
        {
          faces_at_place.resize(std::max(faces_at_place.size(), place + 1));
          faces_at_place[place].push_back(f);
        }
    std::vector<bool> seen(places.size(), false);
    for (std::size_t first = 0; first < places.size(); ++first)
      {
        if (seen[first])
          continue;
        std::vector<std::size_t> front = {first};
        seen[first]                    = true;
        all_ways.emplace_back();
        std::vector<unsigned int> &joints = all_ways.back().joints;
        while (!front.empty())
          {
            const std::size_t f = front.back();
            front.pop_back();
            all_faces[f].way = all_ways.size() - 1;
            joints.push_back(all_faces[f].face->joint);
            for (const std::size_t place : places[f])
              for (const std::size_t other : faces_at_place[place])
                if (!seen[other])
                  {
                    seen[other] = true;
                    front.push_back(other);
                  }
          }
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
      }
  }


  // The chain of faces is walked beginning at the end that lies against the direction of flow.
  template <int dim>
  void
  UpliftWay<dim>::measure_chain(const std::size_t way,
                                const std::vector<std::vector<std::size_t>> &places,
                                const std::vector<dealii::Point<dim>> &positions)
  {
    std::vector<std::vector<std::size_t>> faces_at_place(positions.size());
    for (std::size_t f = 0; f < places.size(); ++f)
      if (all_faces[f].way == way)
        for (const std::size_t place : places[f])
          faces_at_place[place].push_back(f);
    std::vector<std::size_t> ends;
    for (std::size_t place = 0; place < positions.size(); ++place)
      {
        if (faces_at_place[place].size() == 1)
          ends.push_back(place);
        if (faces_at_place[place].size() > 2)
          throw InputError(fmt::format("{}: the joints {} branch at ({:g}, {:g}), so that they are "
                                       "no way from one end to another. Give each branch a load of "
                                       "its own.",
                                       load_title(load),
                                       joints_of(way),
                                       positions[place][0],
                                       positions[place][1]));
      }
    if (ends.size() != 2)
      throw InputError(fmt::format("{}: the joints {} form a ring, so that they have no upstream "
                                   "end. Divide them into joints with two ends.",
                                   load_title(load),
                                   joints_of(way)));
    if ((positions[ends[1]] - positions[ends[0]]) * flow < 0.)
      std::swap(ends[0], ends[1]);

    double length     = 0.;
    std::size_t place = ends[0], last = places.size();
    while (place != ends[1])
      {
        const auto &here    = faces_at_place[place];
        const std::size_t f = here.front() == last ? here.back() : here.front();
        const bool forwards = places[f][0] == place;
        const double next   = length + corners[f][0].distance(corners[f][1]);
        all_faces[f].along  = forwards ? Vector{length, next} : Vector{next, length};
        all_faces[f].across = {0., 0.};
        length              = next;
        place               = places[f][forwards ? 1 : 0];
        last                = f;
      }
    require_extent(way, (positions[ends[1]] - positions[ends[0]]) * flow, length);
    all_ways[way].shortest = all_ways[way].longest = length;
    all_ways[way].outline.add(
      {{{0., 0., positions[ends[0]][1]}, {length, 0., positions[ends[1]][1]}}});
  }


  template <int dim>
  void
  UpliftWay<dim>::require_extent(const std::size_t way,
                                 const double extent,
                                 const double size) const
  {
    if (extent <= same_place * size)
      throw InputError(fmt::format("{}: joint {} does not extend in the direction of flow ({}), so "
                                   "that it has no upstream end there. Name another upstream end.",
                                   load_title(load),
                                   joints_of(way),
                                   flow_text()));
  }


  template <int dim>
  void
  UpliftWay<dim>::check_drain(const std::size_t way) const
  {
    const double longest = all_ways[way].longest;
    if (load.uplift.drain_distance >= longest)
      throw InputError(
        fmt::format("{}: the drain at the distance {:g} lies outside the joint {}, whose ends are "
                    "{:g} apart. Correct the distance.",
                    load_title(load),
                    load.uplift.drain_distance,
                    joints_of(way),
                    longest));
  }


  template <int dim>
  WayOfWater
  UpliftWay<dim>::line(const std::size_t way, const double across) const
  {
    const PlanOutline &outline = all_ways[way].outline;
    const auto ends =
      outline.slice(std::clamp(across, outline.width()[0], outline.width()[1])).value();
    return {ends[0].along, ends[1].along, ends[0].height, ends[1].height};
  }


  template <int dim>
  std::vector<PlanPoint>
  UpliftWay<dim>::corner_points(const std::size_t face) const
  {
    std::vector<PlanPoint> result;
    for (std::size_t v = 0; v < corners[face].size(); ++v)
      result.push_back(
        {all_faces[face].along[v], all_faces[face].across[v], corners[face][v][dim - 1]});
    return result;
  }


  template <int dim>
  std::vector<PlanPoint>
  UpliftWay<dim>::points(const Face &face,
                         const FaceMap<dim> &map,
                         const std::vector<typename FaceMap<dim>::FacePoint> &figure) const
  {
    std::vector<PlanPoint> result;
    const Vector heights = map.heights();
    for (const auto &at : figure)
      result.push_back({map.interpolate(face.along, at),
                        map.interpolate(face.across, at),
                        map.interpolate(heights, at)});
    return result;
  }


  template <int dim>
  std::vector<WayOfWater>
  UpliftWay<dim>::lines_through(const std::size_t way, const std::vector<PlanPoint> &points) const
  {
    double middle = 0.;
    for (const PlanPoint &point : points)
      middle += point.across / static_cast<double>(points.size());
    std::vector<WayOfWater> result;
    for (const PlanPoint &point : points)
      result.push_back(line(way, just_inside(point.across, middle)));
    return result;
  }


  template <int dim>
  std::string
  UpliftWay<dim>::joints_of(const std::size_t way) const
  {
    std::string text;
    for (const unsigned int joint : all_ways[way].joints)
      text += fmt::format("{}'{}'", text.empty() ? "" : ", ", mesh.joints[joint].name);
    return text;
  }


  template <int dim>
  std::string
  UpliftWay<dim>::flow_text() const
  {
    return fmt::format("{}", fmt::join(&flow[0], &flow[0] + dim, ", "));
  }


  template <int dim>
  std::vector<std::string>
  UpliftWay<dim>::report() const
  {
    const Uplift &uplift    = load.uplift;
    const std::string rule  = !uplift.fills_cracks ? "the same in cracks"
                              : uplift.profile_from == Uplift::ProfileFrom::joint
                                ? "over the whole joint, with full pressure in connected cracks"
                                : "from the tip of connected cracks, with full pressure in them";
    const std::string drain = uplift.drain_distance == 0. || !uplift.fills_cracks ? ""
                              : uplift.drains_after_crack == Uplift::Drains::kept
                                ? "; the drain is kept in the crack"
                                : "; the drain is lost in the crack";
    std::vector<std::string> lines;
    for (std::size_t way = 0; way < all_ways.size(); ++way)
      {
        const double shortest = all_ways[way].shortest, longest = all_ways[way].longest;
        const std::string length = longest - shortest <= same_place * longest
                                     ? fmt::format("{:g}", longest)
                                     : fmt::format("{:g} to {:g}", shortest, longest);
        lines.push_back(fmt::format("load '{}': uplift {}{}; {} of way through {}",
                                    load.name,
                                    rule,
                                    drain,
                                    length,
                                    joints_of(way)));
      }
    return lines;
  }


  template class UpliftWay<2>;
  template class UpliftWay<3>;
} // namespace fuga
