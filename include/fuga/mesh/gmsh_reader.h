// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_gmsh_reader_h
#define fuga_mesh_gmsh_reader_h

#include <fuga/mesh/gmsh_mesh.h>
#include <fuga/mesh/text_scanner.h>

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fuga
{
  /** Largest number of a node or an element. */
  constexpr std::int64_t largest_tag = std::numeric_limits<std::int64_t>::max();
  /**
   * Largest physical tag; one less in magnitude than the smallest int, so that a sign may be
   * removed.
   */
  constexpr std::int64_t largest_group = std::numeric_limits<int>::max();
  /** Remedy for a damaged file. */
  constexpr const char *write_again = "write the mesh file again";

  /** Map from the node numbers of a file, which may have gaps and any order, to 0, 1, 2 ... */
  class NodeNumbers
  {
  public:
    static constexpr unsigned int unknown = static_cast<unsigned int>(-1);

    /**
     * Return the position in @p tags of the second occurrence of a tag, or unknown if all differ.
     */
    unsigned int
    build(const std::vector<std::int64_t> &tags);

    unsigned int
    find(const std::int64_t tag) const;

  private:
    /** A table if the tags are dense, otherwise sorted pairs: a wrong tag must not cost memory. */
    std::vector<unsigned int> table;
    std::vector<std::pair<std::int64_t, unsigned int>> sorted;
  };

  /** An element as given in the file. */
  struct GmshRecord
  {
    MeshEntity entity;
    unsigned int line = 0;
    /** Elementary entity (curve, surface ...) to which it belongs. */
    std::int64_t geometry = 0;
  };

  /** All useful contents of the file, before it is known which dimension is the highest. */
  struct GmshContents
  {
    struct Name
    {
      std::string name;
      unsigned int line = 0;
    };

    std::vector<std::array<double, 3>> nodes;
    std::array<std::vector<GmshRecord>, 4> elements;
    std::map<std::pair<unsigned int, int>, Name> names;
    /** The first element block in more than one physical group, by dimension (line 0: none). */
    std::array<std::pair<unsigned int, std::string>, 4> overlaps;
  };

  /** Reads the sections of a Gmsh file of version 2.2 or 4.1 into GmshContents. */
  class GmshReader
  {
  public:
    explicit GmshReader(TextScanner &text_scanner);

    GmshContents
    read();

  private:
    /** Elementary entities of format 4.1 that are in physical groups. */
    using EntityGroups = std::map<std::pair<unsigned int, std::int64_t>, std::vector<int>>;

    void
    read_format();
    void
    read_physical_names();
    void
    read_physical_name();
    void
    read_entities();
    void
    read_entity(const unsigned int dim);
    void
    read_nodes_2();
    void
    read_nodes_4();
    void
    read_node_block(std::vector<std::int64_t> &tags, std::vector<unsigned int> &lines);
    void
    number_nodes(const std::vector<std::int64_t> &tags, const std::vector<unsigned int> &lines);
    void
    begin_elements();

    void
    read_elements_2();
    void
    read_elements_4();
    /** Read a block of elements and return their number. */
    std::int64_t
    read_element_block();
    void
    read_element(const CellShape shape, const int group, const std::int64_t geometry);
    CellShape
    element_shape(const std::int64_t type) const;
    std::array<double, 3>
    read_point();
    void
    skip_section(const std::string &section);
    void
    require_end_of_section(const std::string_view section);

    TextScanner &scanner;
    GmshContents contents;
    NodeNumbers numbers;
    EntityGroups entity_groups;
    bool version_4     = false;
    bool have_nodes    = false;
    bool have_elements = false;
    bool have_names    = false;
    bool have_entities = false;
  };

  /** Check the contents of a file as a whole and make a mesh of them. */
  GmshMesh
  assemble_gmsh_mesh(const GmshContents &contents,
                     const TextScanner &scanner,
                     const std::string &file_name);
} // namespace fuga

#endif
