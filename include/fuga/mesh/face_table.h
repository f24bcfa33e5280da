// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_face_table_h
#define fuga_mesh_face_table_h

#include <fuga/mesh/joint_splitter.h>

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Table of the cells that meet at every face. A half-face is a face as seen from one of its
   * cells, numbered cell * n_faces + face within the cell. All cells have the same shape.
   */
  class FaceTable
  {
  public:
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /**
     * Build the table. @throws InputError if more than two cells, or two that overlap, share a
     * face.
     */
    FaceTable(const JointedMesh &mesh, const std::string &file_name);

    unsigned int
    n_half_faces() const;

    unsigned int
    cell(const unsigned int half_face) const;

    /** Return the number of the half-face within its cell. */
    unsigned int
    local_face(const unsigned int half_face) const;

    /** Return the same face seen from the other cell; none on the boundary. */
    unsigned int
    neighbour(const unsigned int half_face) const;

    /** Return a half-face with these vertices in any order; none if no cell has such a face. */
    unsigned int
    find(const std::array<unsigned int, 4> &vertices) const;

    /** Return whether two lists of the same vertices have the same orientation. */
    bool
    same_direction(const std::array<unsigned int, 4> &a,
                   const std::array<unsigned int, 4> &b) const;

  private:
    /** Half-faces are looked up by their smallest vertex and then by the others, sorted. */
    struct Entry
    {
      std::array<unsigned int, 3> others;
      unsigned int half_face;
    };

    void
    sort_half_faces(const JointedMesh &mesh);
    void
    connect(const JointedMesh &mesh, const std::string &file_name);
    std::array<unsigned int, 4>
    sorted_vertices(std::array<unsigned int, 4> vertices) const;

    unsigned int faces_per_cell    = 0;
    unsigned int vertices_per_face = 0;
    std::vector<unsigned int> begin;
    std::vector<Entry> entries;
    std::vector<unsigned int> neighbours;
  };
} // namespace fuga

#endif
