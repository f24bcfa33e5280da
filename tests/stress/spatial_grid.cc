// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/spatial_grid.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga::stress
{
  namespace
  {
    constexpr unsigned int hexahedron = 5, tetrahedron = 4;
    constexpr std::array<std::array<const char *, 2>, 3> sides = {
      {{{"left", "right"}}, {{"front", "back"}}, {{"bottom", "top"}}}};

    SpatialGrid::Index
    moved(SpatialGrid::Index index, const unsigned int direction, const std::size_t by)
    {
      index[direction] += by;
      return index;
    }
  } // namespace

  int
  SpatialGrid::body(const Index &cell) const
  {
    // Indices before the grid have wrapped around.
    for (unsigned int d = 0; d < 3; ++d)
      if (cell[d] >= lines[d].size() - 1)
        return none;
    return body_of_cell(cell);
  }

  void
  SpatialGrid::for_each_index(const std::function<void(const Index &)> &action) const
  {
    Index index;
    for (index[2] = 0; index[2] < lines[2].size(); ++index[2])
      for (index[1] = 0; index[1] < lines[1].size(); ++index[1])
        for (index[0] = 0; index[0] < lines[0].size(); ++index[0])
          action(index);
  }

  std::size_t
  SpatialGrid::vertex(const Index &index) const
  {
    return index[0] + lines[0].size() * (index[1] + lines[1].size() * index[2]) + 1;
  }

  void
  SpatialGrid::add_faces(const unsigned int across, FaceGroups &result) const
  {
    const unsigned int first = (across + 1) % 3, second = (across + 2) % 3;
    for_each_index([&](const Index &index) {
      const int before = body(moved(index, across, static_cast<std::size_t>(-1))),
                behind = body(index);
      if (before == behind)
        return;
      const auto name = [&](const int b) { return bodies[static_cast<std::size_t>(b)].name; };
      const std::string group = before == none   ? name(behind) + '_' + sides[across][0]
                                : behind == none ? name(before) + '_' + sides[across][1]
                                                 : name_of_joint(static_cast<std::size_t>(before),
                                                                 static_cast<std::size_t>(behind));
      const std::size_t a = vertex(index), b = vertex(moved(index, first, 1)),
                        c = vertex(moved(moved(index, first, 1), second, 1)),
                        d = vertex(moved(index, second, 1));
      if (!tetrahedra)
        result[group].push_back({a, b, c, d});
      else
        {
          result[group].push_back({a, b, c});
          result[group].push_back({a, c, d});
        }
    });
  }

  SpatialGrid::FaceGroups
  SpatialGrid::faces() const
  {
    FaceGroups result;
    for (unsigned int across = 0; across < 3; ++across)
      add_faces(across, result);
    return result;
  }

  std::array<double, 3>
  SpatialGrid::place(const Index &index) const
  {
    const std::array<double, 3> at = {{lines[0][index[0]], lines[1][index[1]], lines[2][index[2]]}};
    return map ? map(at) : at;
  }

  bool
  SpatialGrid::is_used(const Index &index) const
  {
    for (unsigned int corner = 0; corner < 8; ++corner)
      if (body({{index[0] - corner % 2, index[1] - corner / 2 % 2, index[2] - corner / 4}}) != none)
        return true;
    return false;
  }

  // The six tetrahedra around the diagonal from the first to the last vertex: the diagonals of all
  // faces begin at their first vertex, so that neighbours agree.
  void
  SpatialGrid::add_cell(const Index &cell, MeshText &mesh) const
  {
    const std::size_t group = tag_of_body(static_cast<std::size_t>(body_of_cell(cell)));
    const auto at           = [&](const unsigned int corner) {
      return vertex({{cell[0] + corner % 2, cell[1] + corner / 2 % 2, cell[2] + corner / 4}});
    };
    if (!tetrahedra)
      mesh.add_element(hexahedron, group, {at(0), at(1), at(3), at(2), at(4), at(5), at(7), at(6)});
    else
      for (const auto &[a, b] : {std::make_pair(1u, 3u),
                                 std::make_pair(3u, 2u),
                                 std::make_pair(2u, 6u),
                                 std::make_pair(6u, 4u),
                                 std::make_pair(4u, 5u),
                                 std::make_pair(5u, 1u)})
        mesh.add_element(tetrahedron, group, {at(0), at(a), at(b), at(7)});
  }

  std::string
  SpatialGrid::mesh_text() const
  {
    MeshText mesh = mesh_of_faces();
    for_each_index([&](const Index &index) {
      if (body(index) != none)
        add_cell(index, mesh);
      // Only vertices that a cell uses: others would belong to no body.
      if (is_used(index))
        {
          const std::array<double, 3> point = place(index);
          mesh.add_vertex(vertex(index), point[0], point[1], point[2]);
        }
    });
    return mesh.text();
  }

  double
  SpatialGrid::width() const
  {
    return lines[0].back() - lines[0].front();
  }

  double
  SpatialGrid::largest_aspect() const
  {
    double result = 1.;
    for_each_index([&](const Index &index) {
      if (body(index) == none)
        return;
      std::vector<double> lengths;
      for (unsigned int d = 0; d < 3; ++d)
        lengths.push_back(lines[d][index[d] + 1] - lines[d][index[d]]);
      result = std::max(result, aspect_of(lengths));
    });
    return result;
  }

  double
  SpatialGrid::size_ratio() const
  {
    return size_ratio_of({lines.begin(), lines.end()});
  }

  double
  SpatialGrid::offset() const
  {
    const std::array<double, 3> at = place({{0, 0, 0}});
    return std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  }

  SpatialGrid
  extrude(const GridModel &section, const Vector &y)
  {
    SpatialGrid model;
    static_cast<SceneData &>(model) = section;
    model.lines                     = {{section.x, y, section.y}};
    model.body_of_cell = [cells = section.body_of_cell](const SpatialGrid::Index &cell) {
      return cells(cell[0], cell[2]);
    };
    if (section.map)
      model.map = [map = section.map](const std::array<double, 3> &at) {
        const std::array<double, 2> mapped = map(at[0], at[2]);
        return std::array<double, 3>{{mapped[0], at[1], mapped[1]}};
      };
    for (auto &[boundary, components] : model.supports)
      if (components == "y")
        components = "z";
    for (const GridModel::Body &body : section.bodies)
      model.supports[body.name + "_front"] = model.supports[body.name + "_back"] = "y";
    for (SceneData::Load &load : model.loads)
      if (const auto semicolon = load.value.find(';'); semicolon != load.value.npos)
        load.value.insert(semicolon, "; 0");
    model.section = section;
    return model;
  }
} // namespace fuga::stress
