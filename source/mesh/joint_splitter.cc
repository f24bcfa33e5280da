// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/mesh/cell_geometry.h>
#include <fuga/mesh/face_table.h>
#include <fuga/mesh/joint_report.h>
#include <fuga/mesh/joint_resolver.h>
#include <fuga/mesh/joint_splitter.h>

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>

namespace fuga
{
  namespace
  {
    /** Opens one mesh; each object can be used once. */
    class Splitter
    {
    public:
      Splitter(const GmshMesh &gmsh, const std::vector<JointDefinition> &definitions)
        : mesh(gmsh), joints(definitions)
      {
      }

      JointedMesh
      run();

    private:
      void
      take_over_cells();
      void
      open(const FaceTable &table, const ResolvedFaces &resolved);
      std::vector<unsigned int>
      joint_vertices(const FaceTable &table, const ResolvedFaces &resolved) const;
      unsigned int
      split_vertex(const FaceTable &table,
                   const std::vector<bool> &is_cut,
                   const unsigned int vertex,
                   const std::vector<unsigned int> &cells);
      void
      add_faces(const FaceTable &table, const ResolvedFaces &resolved);
      void
      add_lips(const FaceTable &table, const ResolvedFaces &resolved, const unsigned int joint);
      unsigned int
      label(const std::string &name) const;
      void
      add_unlabelled_faces(const FaceTable &table, const ResolvedFaces &resolved);
      JointedMesh::Face
      face(const FaceTable &table,
           const unsigned int half_face,
           const unsigned int face_label) const;
      void
      add_points();
      void
      add_point(const MeshEntity &point);

      const GmshMesh &mesh;
      const std::vector<JointDefinition> &joints;
      JointedMesh result;
      SplitVertices split_vertices;
    };


    JointedMesh
    Splitter::run()
    {
      if (mesh.cells.empty())
        throw InputError(
          fmt::format("{}: the mesh has no cells; mesh the geometry", mesh.file_name));
      take_over_cells();
      orient_cells(result, mesh.file_name);
      const FaceTable table(result, mesh.file_name);
      const ResolvedFaces resolved = JointResolver(mesh, result, table, joints).run();
      open(table, resolved);
      add_faces(table, resolved);
      add_points();
      for (unsigned int j = 0; j < joints.size(); ++j)
        result.report.push_back(describe_joint(result, joints[j], j, split_vertices));
      return std::move(result);
    }


    void
    Splitter::take_over_cells()
    {
      result.dimension = mesh.dimension;
      result.vertices  = mesh.vertices;
      std::map<int, unsigned int> bodies;
      for (const MeshEntity &cell : mesh.cells)
        bodies.insert({cell.physical_tag, 0});
      InputErrors errors;
      for (auto &[tag, index] : bodies)
        {
          const auto name = mesh.physical_names.find({mesh.dimension, tag});
          if (name == mesh.physical_names.end())
            {
              errors.add(fmt::format(
                "{}: the body with the physical tag {} has no name; every body must have one; "
                "write Physical {}(\"name\", {}) = ... in the geometry",
                mesh.file_name,
                tag,
                mesh.dimension == 2 ? "Surface" : "Volume",
                tag));
              continue;
            }
          index = static_cast<unsigned int>(result.body_names.size());
          result.body_names.push_back(name->second);
        }
      errors.throw_if_any();
      result.cells.reserve(mesh.cells.size());
      for (const MeshEntity &cell : mesh.cells)
        result.cells.push_back({cell.shape, cell.vertices, bodies.at(cell.physical_tag)});
    }


    std::vector<unsigned int>
    Splitter::joint_vertices(const FaceTable &table, const ResolvedFaces &resolved) const
    {
      const unsigned int n = n_vertices(face_shape(result.cells.front().shape));
      std::vector<unsigned int> vertices;
      for (const auto &openings : resolved.openings)
        for (const ResolvedFaces::Opening &o : openings)
          {
            const auto f =
              face_vertices(result.cells[table.cell(o.plus)], table.local_face(o.plus));
            vertices.insert(vertices.end(), f.begin(), f.begin() + n);
          }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      return vertices;
    }


    void
    Splitter::open(const FaceTable &table, const ResolvedFaces &resolved)
    {
      std::vector<bool> is_cut(table.n_half_faces(), false);
      for (const auto &openings : resolved.openings)
        for (const ResolvedFaces::Opening &o : openings)
          is_cut[o.plus] = is_cut[o.minus] = true;

      const std::vector<unsigned int> vertices = joint_vertices(table, resolved);
      std::vector<unsigned int> place(mesh.vertices.size(), FaceTable::none);
      std::vector<std::vector<unsigned int>> cells_at(vertices.size());
      for (unsigned int i = 0; i < vertices.size(); ++i)
        place[vertices[i]] = i;
      for (unsigned int c = 0; c < result.cells.size(); ++c)
        for (unsigned int i = 0; i < n_vertices(result.cells[c].shape); ++i)
          if (place[result.cells[c].vertices[i]] != FaceTable::none)
            cells_at[place[result.cells[c].vertices[i]]].push_back(c);

      for (unsigned int i = 0; i < vertices.size(); ++i)
        split_vertices.n_copies[vertices[i]] =
          split_vertex(table, is_cut, vertices[i], cells_at[i]);
    }


    /**
     * Every group of cells around a vertex that is connected through uncut faces gets its own copy;
     * the group of the first cell keeps the vertex. The number of groups is returned.
     */
    unsigned int
    Splitter::split_vertex(const FaceTable &table,
                           const std::vector<bool> &is_cut,
                           const unsigned int vertex,
                           const std::vector<unsigned int> &cells)
    {
      std::vector<unsigned int> parent(cells.size());
      std::iota(parent.begin(), parent.end(), 0U);
      const auto root = [&parent](unsigned int i) {
        while (parent[i] != i)
          i = parent[i] = parent[parent[i]];
        return i;
      };
      const CellShape shape      = result.cells.front().shape;
      const unsigned int n_local = n_vertices(face_shape(shape));
      for (unsigned int i = 0; i < cells.size(); ++i)
        for (unsigned int f = 0; f < n_faces(shape); ++f)
          {
            const unsigned int half_face = cells[i] * n_faces(shape) + f;
            const auto v                 = face_vertices(result.cells[cells[i]], f);
            const unsigned int other     = table.neighbour(half_face);
            if (is_cut[half_face] || other == FaceTable::none ||
                std::find(v.begin(), v.begin() + n_local, vertex) == v.begin() + n_local)
              continue;
            const auto found     = std::lower_bound(cells.begin(), cells.end(), table.cell(other));
            const unsigned int a = root(i);
            const unsigned int b = root(static_cast<unsigned int>(found - cells.begin()));
            parent[std::max(a, b)] = std::min(a, b);
          }

      std::vector<unsigned int> copy(cells.size(), FaceTable::none);
      unsigned int n = 0;
      for (unsigned int i = 0; i < cells.size(); ++i)
        {
          const unsigned int r = root(i);
          if (copy[r] == FaceTable::none)
            {
              copy[r] = n++ == 0 ? vertex : static_cast<unsigned int>(result.vertices.size());
              if (copy[r] != vertex)
                {
                  result.vertices.push_back(mesh.vertices[vertex]);
                  split_vertices.originals[copy[r]] = vertex;
                }
            }
          auto &v = result.cells[cells[i]].vertices;
          std::replace(v.begin(), v.begin() + n_vertices(shape), vertex, copy[r]);
        }
      return n;
    }


    JointedMesh::Face
    Splitter::face(const FaceTable &table,
                   const unsigned int half_face,
                   const unsigned int face_label) const
    {
      const JointedMesh::Cell &cell = result.cells[table.cell(half_face)];
      return {face_shape(cell.shape), face_vertices(cell, table.local_face(half_face)), face_label};
    }


    void
    Splitter::add_faces(const FaceTable &table, const ResolvedFaces &resolved)
    {
      result.label_names = resolved.group_names;
      for (const ResolvedFaces::Outer &outer : resolved.outer)
        result.faces.push_back(face(table, outer.half_face, outer.group));
      for (unsigned int j = 0; j < joints.size(); ++j)
        if (!joints[j].line.empty())
          add_lips(table, resolved, j);
        else
          result.joints.push_back(
            {joints[j].name,
             label(joints[j].plus_lip),
             joints[j].against_rigid ? JointedMesh::no_label : label(joints[j].minus_lip),
             joints[j].corner_angle});
      add_unlabelled_faces(table, resolved);
    }


    void
    Splitter::add_lips(const FaceTable &table, const ResolvedFaces &resolved, const unsigned int j)
    {
      const auto first = static_cast<unsigned int>(result.label_names.size());
      for (const char *const side : {"+", "-"})
        {
          const std::string name = joints[j].name + side;
          if (label(name) != JointedMesh::no_label)
            throw InputError(fmt::format(
              "joint '{}': its lip is to be called '{}', but {} has a group of that name; "
              "names must differ; rename the joint or the group",
              joints[j].name,
              name,
              mesh.file_name));
          result.label_names.push_back(name);
        }
      for (const ResolvedFaces::Opening &o : resolved.openings[j])
        result.faces.push_back(face(table, o.plus, first));
      for (const ResolvedFaces::Opening &o : resolved.openings[j])
        {
          result.faces.push_back(face(table, o.minus, first + 1));
          // the same vertices, once in each direction: the face is still closed
          const JointedMesh::Face minus = result.faces.back();
          auto plus_vertices            = face(table, o.plus, first).vertices;
          auto minus_vertices           = minus.vertices;
          std::sort(plus_vertices.begin(), plus_vertices.end());
          std::sort(minus_vertices.begin(), minus_vertices.end());
          if (plus_vertices == minus_vertices)
            throw InputError(fmt::format(
              "joint '{}': the face at {} cannot open, because all its vertices are tips of "
              "the joint inside the mesh; a joint needs a vertex between its tips; refine "
              "the mesh along the line",
              joints[j].name,
              face_centre(minus.shape, minus.vertices, result.vertices)));
        }
      result.joints.push_back({joints[j].name, first, first + 1, joints[j].corner_angle});
    }


    unsigned int
    Splitter::label(const std::string &name) const
    {
      const auto place = std::find(result.label_names.begin(), result.label_names.end(), name);
      return place == result.label_names.end()
               ? JointedMesh::no_label
               : static_cast<unsigned int>(place - result.label_names.begin());
    }


    void
    Splitter::add_unlabelled_faces(const FaceTable &table, const ResolvedFaces &resolved)
    {
      std::vector<bool> is_labelled(table.n_half_faces(), false);
      for (const ResolvedFaces::Outer &outer : resolved.outer)
        is_labelled[outer.half_face] = true;
      for (unsigned int h = 0; h < table.n_half_faces(); ++h)
        if (table.neighbour(h) == FaceTable::none && !is_labelled[h])
          result.unlabelled_faces.push_back(face(table, h, JointedMesh::no_label));
    }


    void
    Splitter::add_points()
    {
      InputErrors errors;
      for (const MeshEntity &point : mesh.points)
        errors.attempt([&]() { add_point(point); });
      errors.throw_if_any();
    }


    void
    Splitter::add_point(const MeshEntity &point)
    {
      const auto name           = mesh.physical_names.find({0, point.physical_tag});
      const unsigned int vertex = point.vertices[0];
      if (name == mesh.physical_names.end())
        throw InputError(fmt::format(
          "{}: the point group {} has no name; write Physical Point(\"name\", {}) = ... "
          "in the geometry",
          mesh.file_name,
          point.physical_tag,
          point.physical_tag));
      const auto copies = split_vertices.n_copies.find(vertex);
      if (copies != split_vertices.n_copies.end() && copies->second > 1)
        throw InputError(fmt::format(
          "{}: the named point '{}' at {} lies on a joint, where the mesh is opened and "
          "has {} vertices; a named point must be one vertex; move it off the joint",
          mesh.file_name,
          name->second,
          print_point(mesh.vertices[vertex], mesh.dimension),
          copies->second));
      result.points.push_back({vertex, name->second});
    }
  } // namespace


  JointedMesh
  split_joints(const GmshMesh &mesh, const std::vector<JointDefinition> &joints)
  {
    return Splitter(mesh, joints).run();
  }
} // namespace fuga
