// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The $Elements section: the part of GmshReader that knows Gmsh's element types.

#include <fuga/mesh/gmsh_reader.h>

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  unsigned int
  NodeNumbers::build(const std::vector<std::int64_t> &tags)
  {
    const std::int64_t largest = tags.empty() ? 0 : *std::max_element(tags.begin(), tags.end());
    // compared in this way the sum cannot overflow
    if (largest / 4 <= static_cast<std::int64_t>(tags.size()) + 250)
      {
        table.assign(static_cast<std::size_t>(largest) + 1, unknown);
        for (unsigned int i = 0; i < tags.size(); ++i)
          {
            unsigned int &place = table[static_cast<std::size_t>(tags[i])];
            if (place != unknown)
              return i;
            place = i;
          }
        return unknown;
      }
    for (unsigned int i = 0; i < tags.size(); ++i)
      sorted.emplace_back(tags[i], i);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first)
        return sorted[i].second;
    return unknown;
  }


  unsigned int
  NodeNumbers::find(const std::int64_t tag) const
  {
    if (!table.empty())
      return tag >= 0 && static_cast<std::size_t>(tag) < table.size()
               ? table[static_cast<std::size_t>(tag)]
               : unknown;
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(tag, 0U));
    return place != sorted.end() && place->first == tag ? place->second : unknown;
  }


  CellShape
  GmshReader::element_shape(const std::int64_t type) const
  {
    switch (type)
      {
        case 1:
          return CellShape::line;
        case 2:
          return CellShape::triangle;
        case 3:
          return CellShape::quadrilateral;
        case 4:
          return CellShape::tetrahedron;
        case 5:
          return CellShape::hexahedron;
        case 15:
          return CellShape::point;
        case 6:
        case 7:
          scanner.fail(
            fmt::format("the mesh has {} (element type {}); allowed are triangles, "
                        "quadrilaterals, tetrahedra and hexahedra; mesh with tetrahedra or "
                        "hexahedra only",
                        type == 6 ? "prisms" : "pyramids",
                        type));
        default:
          break;
      }
    if (type >= 8 && type <= 140)
      scanner.fail(
        fmt::format("element type {} is of second or higher order; allowed are first-order "
                    "elements; set Mesh.ElementOrder=1 in Gmsh (the polynomial degree is set in "
                    "the parameter file)",
                    type));
    scanner.fail(
      fmt::format("element type {} is unknown; allowed are points (15), lines (1), triangles (2), "
                  "quadrilaterals (3), tetrahedra (4) and hexahedra (5); {}",
                  type,
                  write_again));
  }


  void
  GmshReader::read_element(const CellShape shape, const int group, const std::int64_t geometry)
  {
    GmshRecord record;
    record.line                = scanner.line_number();
    record.geometry            = geometry;
    record.entity.shape        = shape;
    record.entity.physical_tag = std::abs(group);
    auto &vertices             = record.entity.vertices;
    const unsigned int n       = n_vertices(shape);
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::int64_t tag = scanner.integer("a node of an element", 1, largest_tag);
        vertices[i]            = numbers.find(tag);
        if (vertices[i] == NodeNumbers::unknown)
          scanner.fail(
            fmt::format("the element uses node {}, which is not in $Nodes; {}", tag, write_again));
        for (unsigned int j = 0; j < i; ++j)
          if (vertices[j] == vertices[i])
            scanner.fail(
              fmt::format("the element uses node {} twice, it is degenerate; all its nodes must "
                          "differ; remesh the geometry",
                          tag));
      }
    scanner.require_end_of_line("the nodes of an element");
    // a negative group means the direction opposite to that of the geometry
    if (group < 0 && dimension(shape) < 3)
      std::reverse(vertices.begin() + (n > 2 ? 1 : 0), vertices.begin() + n);
    const unsigned int dim = dimension(shape);
    // lines and points can never be cells, so without a group they mean nothing
    if (dim > 1 || group != 0)
      contents.elements[dim].push_back(record);
  }


  void
  GmshReader::begin_elements()
  {
    if (!have_nodes || have_elements)
      scanner.fail(fmt::format("section $Elements {}; allowed is one, after $Nodes; {}",
                               have_elements ? "is there twice" : "comes before $Nodes",
                               write_again));
    have_elements = true;
    scanner.require_line("Elements");
  }


  void
  GmshReader::read_elements_2()
  {
    begin_elements();
    const std::int64_t n = scanner.integer("the number of elements", 1, largest_tag);
    scanner.require_end_of_line("the number of elements");
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("Elements");
        scanner.integer("the number of an element", 0, largest_tag);
        const CellShape shape = element_shape(scanner.integer("the type of an element", 1, 100000));
        const std::int64_t n_tags =
          scanner.integer("the number of tags of an element", 0, largest_tag);
        std::array<std::int64_t, 2> tags{};
        // further tags concern partitions; a wrong count ends with the line
        for (std::int64_t t = 0; t < n_tags; ++t)
          {
            const std::int64_t tag =
              scanner.integer(t == 0 ? "the physical group of an element" : "a tag of an element",
                              t == 0 ? -largest_group : -largest_tag,
                              t == 0 ? largest_group : largest_tag);
            if (t < 2)
              tags[static_cast<std::size_t>(t)] = tag;
          }
        read_element(shape, static_cast<int>(tags[0]), tags[1]);
      }
    require_end_of_section("Elements");
  }


  void
  GmshReader::read_elements_4()
  {
    begin_elements();
    const unsigned int first_line = scanner.line_number();
    const std::int64_t n_blocks   = scanner.integer("the number of element blocks", 1, largest_tag);
    const std::int64_t n          = scanner.integer("the number of elements", 1, largest_tag);
    scanner.integer("the smallest element number", 0, largest_tag);
    scanner.integer("the largest element number", 0, largest_tag);
    scanner.require_end_of_line("four numbers");
    std::int64_t n_found = 0;
    for (std::int64_t i = 0; i < n_blocks; ++i)
      {
        scanner.require_line("Elements");
        n_found += read_element_block();
      }
    if (n_found != n)
      scanner.fail_at(
        first_line,
        fmt::format(
          "{} elements are announced, but the blocks hold {}; {}", n, n_found, write_again));
    require_end_of_section("Elements");
  }


  std::int64_t
  GmshReader::read_element_block()
  {
    const auto dim =
      static_cast<unsigned int>(scanner.integer("the dimension of an element block", 0, 3));
    const std::int64_t geometry =
      scanner.integer("the entity of an element block", -largest_tag, largest_tag);
    const CellShape shape = element_shape(scanner.integer("the type of an element", 1, 100000));
    const std::int64_t n  = scanner.integer("the number of elements of a block", 0, largest_tag);
    scanner.require_end_of_line("four numbers");
    if (dimension(shape) != dim)
      scanner.fail(
        fmt::format("a block of dimension {} holds elements of dimension {}; they must agree; {}",
                    dim,
                    dimension(shape),
                    write_again));
    const auto found = entity_groups.find({dim, geometry});
    const int group  = found == entity_groups.end() ? 0 : found->second.front();
    if (found != entity_groups.end() && found->second.size() > 1 && n > 0 &&
        contents.overlaps[dim].first == 0)
      contents.overlaps[dim] = {
        scanner.line_number(),
        fmt::format("entity {} is in {} physical groups ({}, {}{}); allowed is one; take it "
                    "out of all but one Physical list in the geometry",
                    geometry,
                    found->second.size(),
                    found->second[0],
                    found->second[1],
                    found->second.size() > 2 ? " ..." : "")};
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("Elements");
        scanner.integer("the number of an element", 0, largest_tag);
        read_element(shape, group, geometry);
      }
    return n;
  }
} // namespace fuga
