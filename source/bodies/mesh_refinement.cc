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

    template <int dim>
    struct Lip
    {
      std::vector<Cell<dim>> cells;
      std::vector<dealii::Point<dim>> centers;
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
              lip.cells.push_back(cell);
              lip.centers.push_back(cell->face(f)->center());
            }
      return lip;
    }

    /** Cells that face each other across a joint. */
    template <int dim>
    std::vector<std::pair<Cell<dim>, Cell<dim>>>
    find_partners(const dealii::Triangulation<dim> &mesh, const JointedMesh &jointed)
    {
      std::vector<std::pair<Cell<dim>, Cell<dim>>> partners;
      for (const JointedMesh::Joint &joint : jointed.joints)
        {
          if (joint.minus_label == JointedMesh::no_label)
            continue;
          const Lip<dim> plus  = find_lip<dim>(mesh, joint.plus_label),
                         minus = find_lip<dim>(mesh, joint.minus_label);
          const PointMatcher<dim> matcher(minus.centers);
          for (std::size_t i = 0; i < plus.cells.size(); ++i)
            if (const unsigned int other =
                  matcher.find(plus.centers[i], matching_tolerance * plus.cells[i]->diameter());
                other != PointMatcher<dim>::not_found) // lips without partner are refused elsewhere
              partners.emplace_back(plus.cells[i], minus.cells[other]);
        }
      return partners;
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
    const auto partners = find_partners<dim>(mesh, jointed);
    for (bool changed = true; changed;)
      {
        changed = false;
        mesh.prepare_coarsening_and_refinement();
        for (const auto &[one, other] : partners)
          if (bool(one->refine_flag_set()) != bool(other->refine_flag_set()))
            {
              one->set_refine_flag();
              other->set_refine_flag();
              changed = true;
            }
      }
    mesh.execute_coarsening_and_refinement();
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
