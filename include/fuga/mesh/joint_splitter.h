// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_joint_splitter_h
#define fuga_mesh_joint_splitter_h

#include <fuga/mesh/gmsh_mesh.h>

namespace fuga
{
  /**
   * Defines a joint in the mesh, in exactly one of two ways:
   * - `line` (a named line or surface inside a conforming mesh) with the two bodies that meet
   *   there; the splitter opens the mesh along it. The same body on both sides is allowed (a
   *   crack): the plus side is then the left of the line as it is drawn in the mesh.
   * - `plus_lip` and `minus_lip`, named boundary groups of a mesh that is already open; an empty
   *   minus_lip with `against_rigid` set means a rigid, fixed obstacle.
   *
   * The normal points from the minus to the plus side. `line` with `against_rigid` is not allowed.
   *
   * Neighbouring faces that meet at more than `corner_angle` degrees belong to different straight
   * parts of the joint; at 180 there is one part.
   */
  struct JointDefinition
  {
    std::string name;
    std::string line;
    std::string plus_body;
    std::string minus_body;
    std::string plus_lip;
    std::string minus_lip;
    bool against_rigid  = false;
    double corner_angle = 30.;
  };

  /**
   * The mesh in the form that the bodies need: open along every joint, with groups resolved to
   * numbers.
   */
  struct JointedMesh
  {
    static constexpr unsigned int no_label = static_cast<unsigned int>(-1);

    struct Cell
    {
      CellShape shape = CellShape::quadrilateral;
      std::array<unsigned int, 8> vertices{};
      /** Index into body_names. */
      unsigned int body = 0;
    };

    /**
     * A boundary face with its label. Every face of the boundary of the open mesh that has a group,
     * and both lips of every joint, occur exactly once. The vertices are ordered counter-clockwise
     * seen from outside; in 2D the body is to the left.
     */
    struct Face
    {
      CellShape shape = CellShape::line;
      std::array<unsigned int, 4> vertices{};
      /** Index into label_names. */
      unsigned int label = 0;
    };

    struct NamedPoint
    {
      unsigned int vertex = 0;
      std::string name;
    };

    struct Joint
    {
      std::string name;
      unsigned int plus_label  = 0;
      unsigned int minus_label = no_label; // no_label: against a rigid obstacle
      /** See JointDefinition. */
      double corner_angle = 30.;
    };

    unsigned int dimension = 0;
    std::vector<std::array<double, 3>> vertices;
    std::vector<Cell> cells;
    /** The k-th faces of the two lips of a split joint lie on each other. */
    std::vector<Face> faces;
    /** Faces of the boundary of the open mesh in no group; their label is no_label. */
    std::vector<Face> unlabelled_faces;
    std::vector<NamedPoint> points;
    std::vector<std::string> body_names;
    /** Names of boundary groups; the lips of a split joint J are called "J+" and "J-". */
    std::vector<std::string> label_names;
    std::vector<Joint> joints;
    /**
     * Description of the splitting for the log, one line per joint: faces, length, vertices
     * doubled, tips inside a body, branches, orientation.
     */
    std::vector<std::string> report;
  };

  /**
   * Open @p mesh along the joints and resolve all names. Bodies are the physical groups of the
   * cells. A vertex of a joint line is replaced by as many copies as there are groups of cells
   * around it that are still connected through faces which are not on a joint; a tip inside a body
   * therefore stays one vertex, and T and X junctions are treated correctly.
   * @throws InputError naming the group, the joint, coordinates and the remedy: unknown names (with
   * the names that exist), a line that is not between the two bodies, a line on the outer boundary,
   * lips that touch no cell or lie inside the mesh, a face in two joints, faces in no cell, an
   * inner line group that no joint uses. Unused vertices are dropped silently.
   */
  JointedMesh
  split_joints(const GmshMesh &mesh, const std::vector<JointDefinition> &joints);
} // namespace fuga

#endif
