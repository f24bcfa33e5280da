// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/mesh/gmsh_reader.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Return Gmsh's word for a group of elements, as written in a .geo file. */
    const char *
    physical_word(const unsigned int dim)
    {
      constexpr std::array<const char *, 4> words{
        {"Physical Point", "Physical Curve", "Physical Surface", "Physical Volume"}};
      return words[dim];
    }

    /** Makes a GmshMesh from the contents of a file; each object can be used once. */
    class Assembly
    {
    public:
      Assembly(const GmshContents &file_contents, const TextScanner &text_scanner)
        : contents(file_contents), scanner(text_scanner)
      {
      }

      GmshMesh
      run();

    private:
      void
      find_dimension();
      void
      check_names() const;
      void
      check_cells() const;
      void
      check_group_has_name(const unsigned int dim, const GmshRecord &record) const;
      void
      check_overlaps(const unsigned int dim) const;
      [[noreturn]] void
      fail_overlap(const GmshRecord &first, const GmshRecord &second) const;
      void
      compress_vertices();
      void
      check_plane() const;
      void
      copy(const unsigned int dim, std::vector<MeshEntity> &entities) const;

      const GmshContents &contents;
      const TextScanner &scanner;
      GmshMesh mesh;
      std::vector<unsigned int> new_number;
    };


    GmshMesh
    Assembly::run()
    {
      find_dimension();
      check_names();
      check_cells();
      for (const unsigned int dim : {mesh.dimension, mesh.dimension - 1, 0U})
        {
          if (contents.overlaps[dim].first != 0)
            scanner.fail_at(contents.overlaps[dim].first, contents.overlaps[dim].second);
          if (dim > 0)
            check_overlaps(dim);
        }
      compress_vertices();
      check_plane();
      copy(mesh.dimension, mesh.cells);
      copy(mesh.dimension - 1, mesh.faces);
      copy(0, mesh.points);
      for (const auto &[key, name] : contents.names)
        mesh.physical_names.insert({key, name.name});
      return std::move(mesh);
    }


    void
    Assembly::find_dimension()
    {
      mesh.dimension = contents.elements[3].empty() ? 2 : 3;
      if (contents.elements[mesh.dimension].empty())
        scanner.fail(
          "the mesh has no cells; surfaces (2D) or volumes (3D) must be meshed and saved; mesh "
          "with gmsh -2 or -3 and put them in a Physical Surface or Physical Volume");
    }


    /** The parameter file refers to groups by names, so each name must mean one group of its
     * dimension. */
    void
    Assembly::check_names() const
    {
      std::map<std::pair<unsigned int, std::string>, int> tags;
      for (const auto &[key, name] : contents.names)
        {
          const auto [other, is_new] = tags.insert({{key.first, name.name}, key.second});
          if (!is_new)
            scanner.fail_at(
              name.line,
              fmt::format("physical groups {} and {} of dimension {} have the same name {}; "
                          "names must differ; rename one in the geometry or join the groups",
                          other->second,
                          key.second,
                          key.first,
                          TextScanner::quote(name.name)));
        }
    }


    void
    Assembly::check_cells() const
    {
      const std::vector<GmshRecord> &cells = contents.elements[mesh.dimension];
      for (const GmshRecord &cell : cells)
        if (cell.entity.shape != cells.front().entity.shape)
          scanner.fail_at(
            cell.line,
            fmt::format(
              "the mesh mixes {}; allowed are cells of one shape; {}",
              mesh.dimension == 2 ? "triangles and quadrilaterals" : "tetrahedra and hexahedra",
              mesh.dimension == 2 ? "use Recombine Surface for all surfaces with "
                                    "Mesh.SubdivisionAlgorithm=1 (all quadrilaterals), or for none"
                                  : "mesh all volumes with tetrahedra, or all with hexahedra"));
      for (const GmshRecord &cell : cells)
        if (cell.entity.physical_tag == 0)
          scanner.fail_at(
            cell.line,
            fmt::format(
              "this cell is in no physical group, so it belongs to no body; every cell must be in "
              "one; write {}(\"name\") = {{{}}}; in the geometry",
              physical_word(mesh.dimension),
              cell.geometry));
      for (unsigned int dim : {mesh.dimension, mesh.dimension - 1, 0U})
        {
          int last = 0;
          for (const GmshRecord &record : contents.elements[dim])
            if (record.entity.physical_tag != 0 && record.entity.physical_tag != last)
              {
                check_group_has_name(dim, record);
                last = record.entity.physical_tag;
              }
        }
    }


    void
    Assembly::check_group_has_name(const unsigned int dim, const GmshRecord &record) const
    {
      const int tag = record.entity.physical_tag;
      if (contents.names.count({dim, tag}) == 0)
        scanner.fail_at(
          record.line,
          fmt::format("the physical group {} of dimension {} has no name in $PhysicalNames; every "
                      "group must have one; write {}(\"name\", {}) = {{{}}}; in the geometry",
                      tag,
                      dim,
                      physical_word(dim),
                      tag,
                      record.geometry));
    }


    unsigned int
    smallest_vertex(const MeshEntity &entity)
    {
      return *std::min_element(entity.vertices.begin(),
                               entity.vertices.begin() + n_vertices(entity.shape));
    }


    /** An element without its direction; elements with the same vertices are sorted next to each
     * other. */
    struct VertexSet
    {
      std::array<unsigned int, 8> vertices;
      unsigned int element;

      VertexSet(const MeshEntity &entity, const unsigned int index)
        : vertices(entity.vertices), element(index)
      {
        std::sort(vertices.begin(), vertices.begin() + n_vertices(entity.shape));
      }

      bool
      operator<(const VertexSet &other) const
      {
        return vertices != other.vertices ? vertices < other.vertices : element < other.element;
      }
    };


    /**
     * Format 2.2 writes an element once for every group that contains it, so elements with the same
     * vertices are looked for. Elements are sorted into bins by their smallest vertex, so that few
     * are compared.
     */
    void
    Assembly::check_overlaps(const unsigned int dim) const
    {
      const std::vector<GmshRecord> &records = contents.elements[dim];
      std::vector<unsigned int> begin(contents.nodes.size() + 1, 0);
      for (const GmshRecord &record : records)
        ++begin[smallest_vertex(record.entity) + 1];
      for (std::size_t i = 1; i < begin.size(); ++i)
        begin[i] += begin[i - 1];
      std::vector<unsigned int> order(records.size());
      std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
      for (unsigned int i = 0; i < records.size(); ++i)
        order[next[smallest_vertex(records[i].entity)]++] = i;

      std::vector<VertexSet> bin;
      for (std::size_t v = 0; v + 1 < begin.size(); ++v)
        {
          bin.clear();
          for (unsigned int i = begin[v]; i < begin[v + 1]; ++i)
            if (records[order[i]].entity.physical_tag != 0)
              bin.emplace_back(records[order[i]].entity, order[i]);
          std::sort(bin.begin(), bin.end());
          for (std::size_t i = 1; i < bin.size(); ++i)
            if (bin[i].vertices == bin[i - 1].vertices)
              fail_overlap(records[bin[i - 1].element], records[bin[i].element]);
        }
    }


    void
    Assembly::fail_overlap(const GmshRecord &first, const GmshRecord &second) const
    {
      scanner.fail_at(
        second.line,
        fmt::format("the element has the same nodes as that of line {}, once in physical "
                    "group {} and once in {}; allowed is one; take it out of all but one "
                    "Physical list in the geometry",
                    first.line,
                    first.entity.physical_tag,
                    second.entity.physical_tag));
    }


    void
    Assembly::compress_vertices()
    {
      new_number.assign(contents.nodes.size(), NodeNumbers::unknown);
      for (const GmshRecord &cell : contents.elements[mesh.dimension])
        for (unsigned int i = 0; i < n_vertices(cell.entity.shape); ++i)
          new_number[cell.entity.vertices[i]] = 0;
      for (std::size_t i = 0; i < new_number.size(); ++i)
        if (new_number[i] == 0)
          {
            new_number[i] = static_cast<unsigned int>(mesh.vertices.size());
            mesh.vertices.push_back(contents.nodes[i]);
          }
    }


    void
    Assembly::check_plane() const
    {
      if (mesh.dimension != 2)
        return;
      double largest = 0;
      for (const auto &x : mesh.vertices)
        largest = std::max(
          {largest, std::abs(x[0] - mesh.vertices[0][0]), std::abs(x[1] - mesh.vertices[0][1])});
      for (const auto &x : mesh.vertices)
        if (std::abs(x[2] - mesh.vertices[0][2]) > 1e-10 * largest)
          scanner.fail_at(
            contents.elements[2].front().line,
            fmt::format("the plane mesh is not in a plane z = const: z = {:g} at ({:g}, {:g}) but "
                        "z = {:g} at ({:g}, {:g}); all z must be equal; draw the geometry in the "
                        "x-y plane or mesh volumes",
                        x[2],
                        x[0],
                        x[1],
                        mesh.vertices[0][2],
                        mesh.vertices[0][0],
                        mesh.vertices[0][1]));
    }


    /** The elements that are in a group are copied, with the new vertex numbers. */
    void
    Assembly::copy(const unsigned int dim, std::vector<MeshEntity> &entities) const
    {
      for (const GmshRecord &record : contents.elements[dim])
        if (record.entity.physical_tag != 0)
          {
            entities.push_back(record.entity);
            for (unsigned int i = 0; i < n_vertices(record.entity.shape); ++i)
              {
                const unsigned int old      = record.entity.vertices[i];
                const auto &x               = contents.nodes[old];
                entities.back().vertices[i] = new_number[old];
                if (new_number[old] == NodeNumbers::unknown)
                  scanner.fail_at(
                    record.line,
                    fmt::format(
                      "physical group {} holds a {} at ({:g}, {:g}, {:g}) that no cell "
                      "has as a vertex; groups must lie on the mesh; embed it "
                      "(Point{{..}} In Surface, Curve{{..}} In Surface) or remove it "
                      "from the group",
                      TextScanner::quote(contents.names.at({dim, record.entity.physical_tag}).name),
                      dim == 0 ? "point" : "face",
                      x[0],
                      x[1],
                      x[2]));
              }
          }
    }
  } // namespace


  GmshMesh
  assemble_gmsh_mesh(const GmshContents &contents,
                     const TextScanner &scanner,
                     const std::string &file_name)
  {
    GmshMesh mesh  = Assembly(contents, scanner).run();
    mesh.file_name = file_name;
    return mesh;
  }
} // namespace fuga
