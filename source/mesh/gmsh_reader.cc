// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/mesh/gmsh_reader.h>

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  GmshReader::GmshReader(TextScanner &text_scanner) : scanner(text_scanner)
  {
  }


  GmshContents
  GmshReader::read()
  {
    if (!scanner.next_line())
      scanner.fail(
        "the mesh file is empty; a Gmsh file of version 2.2 or 4.1 is needed; run Gmsh again");
    if (scanner.line() != "$MeshFormat")
      scanner.fail(
        fmt::format("the file begins with {}, not with $MeshFormat; a Gmsh file of version 2.2 "
                    "or 4.1 is needed; convert the mesh with gmsh FILE -save -format msh41 -o "
                    "NEW.msh",
                    TextScanner::quote(scanner.line())));
    read_format();
    while (scanner.next_line())
      {
        const std::string_view section = scanner.line();
        if (section.size() < 2 || section.front() != '$')
          scanner.fail(
            fmt::format("expected the beginning of a section, such as $Nodes, but found {}; "
                        "{}",
                        TextScanner::quote(section),
                        write_again));
        if (section == "$PhysicalNames")
          read_physical_names();
        else if (section == "$Entities" && version_4)
          read_entities();
        else if (section == "$PartitionedEntities")
          scanner.fail("the mesh is partitioned; only whole meshes are read; save it before it is "
                       "partitioned");
        else if (section == "$Nodes")
          version_4 ? read_nodes_4() : read_nodes_2();
        else if (section == "$Elements")
          version_4 ? read_elements_4() : read_elements_2();
        else
          skip_section(std::string(section.substr(1)));
      }
    if (!have_elements)
      scanner.fail(
        fmt::format("the file has no section ${}; both $Nodes and $Elements are needed; {}",
                    have_nodes ? "Elements" : "Nodes",
                    "mesh the geometry in Gmsh before saving (gmsh -2 or -3)"));
    return std::move(contents);
  }


  void
  GmshReader::read_format()
  {
    constexpr const char *remedy =
      "convert it with gmsh FILE -save -format msh41 -setnumber Mesh.Binary 0 -o NEW.msh";
    scanner.require_line("MeshFormat");
    const std::string_view version = scanner.token();
    if (version != "2.2" && version != "4.1")
      scanner.fail(
        fmt::format("the file has version {} of Gmsh's format; allowed are 2.2 and 4.1; {}",
                    TextScanner::quote(version),
                    remedy));
    version_4 = version == "4.1";
    if (scanner.integer("the file type", 0, 1) == 1)
      scanner.fail(fmt::format("the file is binary; only ASCII files are read; {}", remedy));
    scanner.integer("the size of a number", 1, 16);
    scanner.require_end_of_line("the version, the file type and the size of a number");
    require_end_of_section("MeshFormat");
  }


  void
  GmshReader::require_end_of_section(const std::string_view section)
  {
    scanner.require_line(section);
    const std::string_view line = scanner.line();
    if (line.substr(0, 4) != "$End" || line.substr(4) != section)
      scanner.fail(
        fmt::format("section ${} should end here with $End{}, but the line is {}; the count at "
                    "its beginning may be wrong; {}",
                    section,
                    section,
                    TextScanner::quote(line),
                    write_again));
  }


  void
  GmshReader::skip_section(const std::string &section)
  {
    const std::string end = "$End" + section;
    do
      scanner.require_line(section.substr(0, 40));
    while (scanner.line() != end);
  }


  void
  GmshReader::read_physical_names()
  {
    if (have_names)
      scanner.fail(
        fmt::format("there is a second section $PhysicalNames; allowed is one; {}", write_again));
    have_names = true;
    scanner.require_line("PhysicalNames");
    const std::int64_t n = scanner.integer("the number of physical names", 0, largest_tag);
    scanner.require_end_of_line("the number of physical names");
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("PhysicalNames");
        read_physical_name();
      }
    require_end_of_section("PhysicalNames");
  }


  void
  GmshReader::read_physical_name()
  {
    const auto dim =
      static_cast<unsigned int>(scanner.integer("the dimension of a physical group", 0, 3));
    const auto tag = static_cast<int>(
      scanner.integer("the tag of a physical group", -largest_group, largest_group));
    // the name may hold blanks, colons and even quotes: it goes from the first to the last quote
    const std::string_view line = scanner.line();
    const std::size_t first     = line.find('"');
    const std::size_t last      = line.rfind('"');
    if (first == std::string_view::npos || first == last)
      scanner.fail(
        fmt::format("the name of physical group {} is not in quotes; expected is: dimension tag "
                    "\"name\"; {}",
                    tag,
                    write_again));
    std::string_view name = line.substr(first + 1, last - first - 1);
    // the parameter file cannot refer to blanks at the ends of a name
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t'))
      name.remove_suffix(1);
    if (name.empty())
      scanner.fail(
        fmt::format("physical group {} has an empty name; a name of at least one letter is "
                    "needed; write Physical Curve(\"name\") = ... or the like in the geometry",
                    tag));
    if (tag <= 0)
      scanner.fail(
        fmt::format("physical group {} has the tag {}; allowed are tags from 1; give it a "
                    "positive number in the geometry",
                    TextScanner::quote(name),
                    tag));
    if (!contents.names.insert({{dim, tag}, {std::string(name), scanner.line_number()}}).second)
      scanner.fail(
        fmt::format("physical group {} of dimension {} is named twice; one name is allowed; {}",
                    tag,
                    dim,
                    write_again));
  }


  void
  GmshReader::read_entities()
  {
    if (have_entities || have_elements)
      scanner.fail(fmt::format("section $Entities {}; allowed is one, before $Elements; {}",
                               have_entities ? "is there twice" : "comes after $Elements",
                               write_again));
    have_entities = true;
    scanner.require_line("Entities");
    std::array<std::int64_t, 4> n;
    for (std::int64_t &count : n)
      count = scanner.integer("a number of entities", 0, largest_tag);
    scanner.require_end_of_line("the four numbers of entities");
    for (unsigned int dim = 0; dim < 4; ++dim)
      for (std::int64_t i = 0; i < n[dim]; ++i)
        {
          scanner.require_line("Entities");
          read_entity(dim);
        }
    require_end_of_section("Entities");
  }


  void
  GmshReader::read_entity(const unsigned int dim)
  {
    const std::int64_t tag = scanner.integer("the tag of an entity", -largest_tag, largest_tag);
    for (unsigned int i = 0; i < (dim == 0 ? 3 : 6); ++i)
      scanner.coordinate("a bound of an entity");
    const std::int64_t n =
      scanner.integer("the number of physical groups of an entity", 0, largest_tag);
    std::vector<int> groups;
    for (std::int64_t i = 0; i < n; ++i)
      {
        // a negative tag reverses the direction of the elements, 0 means nothing
        groups.push_back(static_cast<int>(
          scanner.integer("the physical group of an entity", -largest_group, largest_group)));
        if (groups.back() == 0)
          scanner.fail(
            fmt::format("an entity is in physical group 0; allowed are tags from 1 (negative: "
                        "reversed); {}",
                        write_again));
      }
    if (!groups.empty() && !entity_groups.insert({{dim, tag}, groups}).second)
      scanner.fail(
        fmt::format("entity {} of dimension {} is there twice; {}", tag, dim, write_again));
  }


  std::array<double, 3>
  GmshReader::read_point()
  {
    std::array<double, 3> point;
    for (unsigned int d = 0; d < 3; ++d)
      point[d] = scanner.coordinate("a coordinate of a node");
    return point;
  }


  void
  GmshReader::read_nodes_2()
  {
    scanner.require_line("Nodes");
    const std::int64_t n = scanner.integer("the number of nodes", 1, largest_tag);
    scanner.require_end_of_line("the number of nodes");
    std::vector<std::int64_t> tags;
    std::vector<unsigned int> lines;
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("Nodes");
        tags.push_back(scanner.integer("the number of a node", 1, largest_tag));
        lines.push_back(scanner.line_number());
        contents.nodes.push_back(read_point());
        scanner.require_end_of_line("a node number and three coordinates");
      }
    number_nodes(tags, lines);
  }


  void
  GmshReader::read_nodes_4()
  {
    scanner.require_line("Nodes");
    const std::int64_t n_blocks = scanner.integer("the number of node blocks", 1, largest_tag);
    const std::int64_t n        = scanner.integer("the number of nodes", 1, largest_tag);
    scanner.integer("the smallest node number", 0, largest_tag);
    scanner.integer("the largest node number", 0, largest_tag);
    scanner.require_end_of_line("four numbers");
    const unsigned int first_line = scanner.line_number();
    std::vector<std::int64_t> tags;
    std::vector<unsigned int> lines;
    for (std::int64_t i = 0; i < n_blocks; ++i)
      {
        scanner.require_line("Nodes");
        read_node_block(tags, lines);
      }
    if (static_cast<std::int64_t>(tags.size()) != n)
      scanner.fail_at(
        first_line,
        fmt::format(
          "{} nodes are announced, but the blocks hold {}; {}", n, tags.size(), write_again));
    number_nodes(tags, lines);
  }


  void
  GmshReader::read_node_block(std::vector<std::int64_t> &tags, std::vector<unsigned int> &lines)
  {
    const std::int64_t dim = scanner.integer("the dimension of a node block", 0, 3);
    scanner.integer("the entity of a node block", -largest_tag, largest_tag);
    const bool parametric = scanner.integer("the parametric flag of a node block", 0, 1) == 1;
    const std::int64_t n  = scanner.integer("the number of nodes of a block", 0, largest_tag);
    scanner.require_end_of_line("four numbers");
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("Nodes");
        tags.push_back(scanner.integer("the number of a node", 1, largest_tag));
        lines.push_back(scanner.line_number());
        scanner.require_end_of_line("a node number");
      }
    for (std::int64_t i = 0; i < n; ++i)
      {
        scanner.require_line("Nodes");
        contents.nodes.push_back(read_point());
        // positions on the curve or surface of the geometry are not used
        for (std::int64_t d = 0; parametric && d < dim; ++d)
          scanner.coordinate("a parametric coordinate of a node");
        scanner.require_end_of_line("the coordinates of a node");
      }
  }


  void
  GmshReader::number_nodes(const std::vector<std::int64_t> &tags,
                           const std::vector<unsigned int> &lines)
  {
    if (have_nodes)
      scanner.fail(
        fmt::format("there is a second section $Nodes; allowed is one; {}", write_again));
    have_nodes = true;
    if (tags.size() >= NodeNumbers::unknown)
      scanner.fail("more than 4e9 nodes; refine less");
    const unsigned int twice = numbers.build(tags);
    if (twice != NodeNumbers::unknown)
      scanner.fail_at(lines[twice],
                      fmt::format("node {} is there twice; every node number is allowed once; {}",
                                  tags[twice],
                                  write_again));
    require_end_of_section("Nodes");
  }
} // namespace fuga
