// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <fuga/bodies/mesh_refinement.h>
#include <fuga/bodies/point_matcher.h>

namespace fuga
{
  namespace
  {
    /** Lips count as one line if they are this close, relative to the size of a cell. */
    constexpr double matching_tolerance = 1e-5;

    template <int dim>
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /** The faces of a lip, by their cells. */
    template <int dim>
    struct Lip
    {
      std::vector<std::pair<Cell<dim>, unsigned int>> faces;
      std::vector<dealii::Point<dim>> centers;
    };

    /** Two faces that face each other across a joint, by their cells. */
    template <int dim>
    struct Partners
    {
      Cell<dim> one, other;
      unsigned int face_of_one, face_of_other;
    };

    template <int dim>
    Lip<dim>
    find_lip(const dealii::Triangulation<dim> &mesh, const unsigned int label)
    {
      Lip<dim> lip;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && cell->face(f)->boundary_id() == label)
            {
              lip.faces.emplace_back(cell, f);
              lip.centers.push_back(cell->face(f)->center());
            }
      return lip;
    }

    template <int dim>
    std::vector<Partners<dim>>
    find_partners(const dealii::Triangulation<dim> &mesh, const JointedMesh &jointed)
    {
      std::vector<Partners<dim>> partners;
      for (const JointedMesh::Joint &joint : jointed.joints)
        {
          if (joint.minus_label == JointedMesh::no_label)
            continue;
          const Lip<dim> plus  = find_lip<dim>(mesh, joint.plus_label),
                         minus = find_lip<dim>(mesh, joint.minus_label);
          const PointMatcher<dim> matcher(minus.centers);
          for (std::size_t i = 0; i < plus.faces.size(); ++i)
            if (const unsigned int other = matcher.find(
                  plus.centers[i], matching_tolerance * plus.faces[i].first->diameter());
                other != PointMatcher<dim>::not_found) // lips without partner are refused elsewhere
              partners.push_back({plus.faces[i].first,
                                  minus.faces[other].first,
                                  plus.faces[i].second,
                                  minus.faces[other].second});
        }
      return partners;
    }


    /** Refines the cells with marks and what has to follow. */
    template <int dim>
    void
    refine_alike(dealii::Triangulation<dim> &mesh, const std::vector<Partners<dim>> &partners)
    {
      for (bool changed = true; changed;)
        {
          changed = false;
          mesh.prepare_coarsening_and_refinement();
          for (const auto &pair : partners)
            if (bool(pair.one->refine_flag_set()) != bool(pair.other->refine_flag_set()))
              {
                pair.one->set_refine_flag();
                pair.other->set_refine_flag();
                changed = true;
              }
        }
      mesh.execute_coarsening_and_refinement();
    }


    /** The vertex in the middle of an edge of a cell, if other cells have divided it. */
    unsigned int
    hanging_vertex(const Cell<3> &cell, const unsigned int edge)
    {
      return cell->line(edge)->has_children() ? cell->line(edge)->child(0)->vertex_index(1)
                                              : dealii::numbers::invalid_unsigned_int;
    }


    /** Marks the cells whose undivided edges let a vertex of one lip hang and not the one that it
     *  faces: cells beside the joint, or at its end. */
    bool
    mark_unlike_edges(dealii::Triangulation<3> &mesh, const std::vector<Partners<3>> &partners)
    {
      std::vector<bool> hangs(mesh.n_vertices(), false), is_unlike(mesh.n_vertices(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int edge : cell->line_indices())
          if (const unsigned int vertex = hanging_vertex(cell, edge); vertex < hangs.size())
            hangs[vertex] = true;
      bool any = false;
      for (const auto &pair : partners)
        {
          const auto face       = pair.one->face(pair.face_of_one),
                     other_face = pair.other->face(pair.face_of_other);
          for (const unsigned int v : face->vertex_indices())
            {
              unsigned int nearest = 0;
              for (const unsigned int w : other_face->vertex_indices())
                if (face->vertex(v).distance(other_face->vertex(w)) <
                    face->vertex(v).distance(other_face->vertex(nearest)))
                  nearest = w;
              const unsigned int here  = face->vertex_index(v),
                                 there = other_face->vertex_index(nearest);
              if (hangs[here] != hangs[there])
                any = is_unlike[hangs[here] ? here : there] = true;
            }
        }
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int edge : cell->line_indices())
          if (const unsigned int vertex = hanging_vertex(cell, edge);
              vertex < hangs.size() && is_unlike[vertex])
            cell->set_refine_flag();
      return any;
    }
  } // namespace


  template <int dim>
  void
  refine_marked_cells(dealii::Triangulation<dim> &mesh,
                      const JointedMesh &jointed,
                      const std::vector<CellKey> &marked)
  {
    for (const CellKey &key : marked)
      mesh.create_cell_iterator(dealii::CellId(key))->set_refine_flag();
    refine_alike<dim>(mesh, find_partners<dim>(mesh, jointed));
    if constexpr (dim == 3)
      for (auto partners = find_partners<dim>(mesh, jointed); mark_unlike_edges(mesh, partners);
           partners      = find_partners<dim>(mesh, jointed))
        refine_alike<dim>(mesh, partners);
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
