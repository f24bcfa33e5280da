// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/grid/tria.h>

#include <fuga/bodies/point_matcher.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/mesh_refinement.h>
#include <fuga/bodies/space/serial_cell_id.h>

#include <algorithm>
#include <map>
#include <set>

namespace fuga
{
  namespace
  {
    using Marks = std::set<dealii::CellId>;

    /** A face of a lip, with its cell, and with the center of the face that it is half of, if its
     * cell was refined. */
    template <int dim>
    struct LipFace
    {
      dealii::CellId cell;
      unsigned int label = 0;
      double size        = 0.;
      dealii::Point<dim> center, center_of_parent;
      std::array<dealii::Point<dim>, dealii::GeometryInfo<dim>::vertices_per_face> corners;
    };

    /** The faces of one lip on all processes. */
    template <int dim>
    using Lip = std::vector<LipFace<dim>>;

    /** The lips by label. */
    template <int dim>
    using Lips = std::map<unsigned int, Lip<dim>>;

    /** A vertex of a lip that hangs on an edge of a cell. */
    struct HangingVertex
    {
      dealii::CellId cell;
      unsigned int label = 0;
      dealii::Point<3> position;
    };


    template <int dim>
    LipFace<dim>
    lip_face(const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
             const unsigned int f)
    {
      LipFace<dim> result;
      const auto face = cell->face(f);
      result.cell     = serial_cell_id(cell);
      result.label    = face->boundary_id();
      result.size     = cell->diameter();
      result.center   = face->center();
      for (const unsigned int v : face->vertex_indices())
        result.corners[v] = face->vertex(v);
      // A child has the numbering of faces of its parent.
      result.center_of_parent =
        cell->level() > 0 ? cell->parent()->face(f)->center() : result.center;
      return result;
    }


    std::set<unsigned int>
    labels_of_lips(const JointedMesh &jointed)
    {
      std::set<unsigned int> result;
      for (const JointedMesh::Joint &joint : jointed.joints)
        if (joint.minus_label != JointedMesh::no_label)
          result.insert({joint.plus_label, joint.minus_label});
      return result;
    }


    /** Call @p action(cell, face number) for all faces on lips that deal.II has on this process. */
    template <int dim, typename Action>
    void
    for_each_lip_face(const dealii::Triangulation<dim> &mesh,
                      const JointedMesh &jointed,
                      const Action &action)
    {
      const std::set<unsigned int> labels = labels_of_lips(jointed);
      for (const auto &cell : mesh.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f) && labels.count(cell->face(f)->boundary_id()) > 0)
              action(cell, f);
    }


    template <int dim>
    Lips<dim>
    find_lips(const dealii::Triangulation<dim> &mesh, const JointedMesh &jointed)
    {
      std::vector<LipFace<dim>> faces;
      for_each_lip_face(mesh, jointed, [&](const auto &cell, const unsigned int f) {
        if (cell->is_locally_owned())
          faces.push_back(lip_face<dim>(cell, f));
      });
      Lips<dim> lips;
      for (const LipFace<dim> &face : processes::gather(std::move(faces)))
        lips[face.label].push_back(face);
      return lips;
    }


    /** Mark the faces of one lip where the other one is finer. Lips were alike before, so that a
     * face has no partner only if either it or its partner has been divided since. */
    template <int dim>
    void
    mark_coarser(const Lip<dim> &finer, const Lip<dim> &lip, Marks &marks)
    {
      std::vector<dealii::Point<dim>> points;
      for (const LipFace<dim> &face : lip)
        points.push_back(face.center);
      const PointMatcher<dim> centers(points);
      for (const LipFace<dim> &face : finer)
        if (const double tolerance = matching_tolerance * face.size;
            centers.find(face.center, tolerance) == PointMatcher<dim>::not_found)
          if (const unsigned int other = centers.find(face.center_of_parent, 2. * tolerance);
              other != PointMatcher<dim>::not_found) // lips without partner are refused elsewhere
            marks.insert(lip[other].cell);
    }


    template <int dim>
    Marks
    unlike_lips(Lips<dim> &lips, const JointedMesh &jointed)
    {
      Marks marks;
      for (const JointedMesh::Joint &joint : jointed.joints)
        if (joint.minus_label != JointedMesh::no_label)
          {
            mark_coarser(lips[joint.plus_label], lips[joint.minus_label], marks);
            mark_coarser(lips[joint.minus_label], lips[joint.plus_label], marks);
          }
      return marks;
    }


    /** Return for each vertex of this process the labels of the lips that it belongs to, whoever
     * owns their cells. */
    std::multimap<unsigned int, unsigned int>
    labels_of_vertices(const dealii::Triangulation<3> &mesh, const JointedMesh &jointed)
    {
      std::multimap<unsigned int, unsigned int> result;
      for_each_lip_face(mesh, jointed, [&](const auto &cell, const unsigned int f) {
        for (const unsigned int v : cell->face(f)->vertex_indices())
          result.emplace(cell->face(f)->vertex_index(v), cell->face(f)->boundary_id());
      });
      return result;
    }


    std::vector<HangingVertex>
    find_hanging_vertices(const dealii::Triangulation<3> &mesh, const JointedMesh &jointed)
    {
      const auto labels = labels_of_vertices(mesh, jointed);
      std::vector<HangingVertex> found;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int edge : cell->line_indices())
            if (cell->line(edge)->has_children())
              {
                const auto half         = cell->line(edge)->child(0);
                const auto [begin, end] = labels.equal_range(half->vertex_index(1));
                for (auto at = begin; at != end; ++at)
                  found.push_back({serial_cell_id(cell), at->second, half->vertex(1)});
              }
      return processes::gather(std::move(found));
    }


    /** The hanging vertices of one lip. */
    class HangingVertices
    {
    public:
      HangingVertices(const std::vector<HangingVertex> &of_all_lips, const unsigned int label)
        : vertices(of_one_lip(of_all_lips, label)), matcher(positions(vertices))
      {
      }

      bool
      contain(const dealii::Point<3> &position, const double tolerance) const
      {
        return matcher.find(position, tolerance) != PointMatcher<3>::not_found;
      }

      /** Mark all cells on whose edges the vertex at this position hangs. */
      void
      mark(const dealii::Point<3> &position, const double tolerance, Marks &marks) const
      {
        for (const HangingVertex &vertex : vertices)
          if (vertex.position.distance(position) <= tolerance)
            marks.insert(vertex.cell);
      }

    private:
      static std::vector<HangingVertex>
      of_one_lip(const std::vector<HangingVertex> &all, const unsigned int label)
      {
        std::vector<HangingVertex> result;
        std::copy_if(all.begin(), all.end(), std::back_inserter(result), [=](const auto &vertex) {
          return vertex.label == label;
        });
        return result;
      }

      static std::vector<dealii::Point<3>>
      positions(const std::vector<HangingVertex> &vertices)
      {
        std::vector<dealii::Point<3>> result;
        for (const HangingVertex &vertex : vertices)
          result.push_back(vertex.position);
        return result;
      }

      std::vector<HangingVertex> vertices;
      PointMatcher<3> matcher;
    };


    /** Mark the cells whose undivided edges let a vertex of one lip hang and not the one that it
     * faces: cells beside the joint, or at its end. Lips are alike. */
    Marks
    unlike_edges(const dealii::Triangulation<3> &mesh, Lips<3> &lips, const JointedMesh &jointed)
    {
      const std::vector<HangingVertex> all = find_hanging_vertices(mesh, jointed);
      Marks marks;
      for (const JointedMesh::Joint &joint : jointed.joints)
        if (joint.minus_label != JointedMesh::no_label)
          {
            const HangingVertices plus(all, joint.plus_label), minus(all, joint.minus_label);
            for (const LipFace<3> &face : lips[joint.plus_label])
              for (const dealii::Point<3> &at : face.corners)
                {
                  const double tolerance = matching_tolerance * face.size;
                  const bool here        = plus.contain(at, tolerance),
                             there       = minus.contain(at, tolerance);
                  if (here != there)
                    (here ? plus : minus).mark(at, tolerance, marks);
                }
          }
      return marks;
    }


    /** Refine the marked cells, and neighbours until levels differ by one at most. */
    template <int dim>
    void
    refine(dealii::Triangulation<dim> &mesh, const Marks &marks)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned() && marks.count(serial_cell_id(cell)) > 0)
          cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
    }


    template <int dim>
    Marks
    what_has_to_follow(const dealii::Triangulation<dim> &mesh, const JointedMesh &jointed)
    {
      Lips<dim> lips = find_lips<dim>(mesh, jointed);
      Marks marks    = unlike_lips(lips, jointed);
      if constexpr (dim == 3)
        if (marks.empty())
          marks = unlike_edges(mesh, lips, jointed);
      return marks;
    }
  } // namespace


  // The refined cells are the smallest set that contains the marked cells and all that have to
  // follow, so the order does not matter.
  template <int dim>
  void
  refine_marked_cells(dealii::Triangulation<dim> &mesh,
                      const JointedMesh &jointed,
                      const std::vector<CellKey> &marked)
  {
    Marks marks;
    for (const CellKey &key : marked)
      marks.insert(dealii::CellId(key));
    for (; !marks.empty(); marks = what_has_to_follow<dim>(mesh, jointed))
      refine<dim>(mesh, marks);
  }


  template void
  refine_marked_cells(dealii::Triangulation<2> &,
                      const JointedMesh &,
                      const std::vector<CellKey> &);
  template void
  refine_marked_cells(dealii::Triangulation<3> &,
                      const JointedMesh &,
                      const std::vector<CellKey> &);
} // namespace fuga
