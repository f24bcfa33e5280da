// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_cell_geometry_h
#define fuga_mesh_cell_geometry_h

#include <fuga/mesh/joint_splitter.h>

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Return the vertices of a face, counter-clockwise seen from outside; in 2D the cell is to the
   * left.
   */
  std::array<unsigned int, 4>
  face_vertices(const JointedMesh::Cell &cell, const unsigned int face);

  /** Return the length of a line or the area of a plane or slightly warped face. */
  double
  face_measure(const CellShape shape,
               const std::array<unsigned int, 4> &face,
               const std::vector<std::array<double, 3>> &vertices);

  /** Return the mean of the vertices of a face as text for messages, "(1, 2)" or "(1, 2, 3)". */
  std::string
  face_centre(const CellShape shape,
              const std::array<unsigned int, 4> &face,
              const std::vector<std::array<double, 3>> &vertices);

  /** Return any point as text in the same form. */
  std::string
  print_point(const std::array<double, 3> &point, const unsigned int dim);

  /**
   * Reverse cells whose vertices are in the wrong order, so that all have positive area or volume.
   * @throws InputError if the Jacobian then vanishes or is negative at a corner of a cell.
   */
  void
  orient_cells(JointedMesh &mesh, const std::string &file_name);
} // namespace fuga

#endif
