// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_model_sizes_h
#define fuga_bodies_condensed_model_sizes_h

#include <fuga/bodies/joints/joint_geometry.h>

namespace fuga
{
  /** The size of a body, as a reviewer would measure it on the drawing. */
  template <int dim>
  struct BodySize
  {
    std::size_t n_cells = 0;
    /**
     * Volume, including the extent across the plane; for a body of revolution that of the full
     * circle [m³].
     */
    double volume = 0.;
    /** Center of the volume; for a body of revolution it is on the axis. */
    dealii::Point<dim> centroid;
  };

  /**
   * Return the sizes of all bodies of the mesh, by JointedMesh::body_names; zero for those that do
   * not exist.
   */
  template <int dim>
  std::vector<BodySize<dim>>
  body_sizes(const Discretization<dim> &discretization, const JointedMesh &mesh);

  /** The size of a joint in the mesh. */
  template <int dim>
  struct JointSize
  {
    /** Area, including the extent across the plane [m²]. */
    double area         = 0.;
    std::size_t n_faces = 0;
    /** Largest distance of two nodes that face each other [m]; 0 against an obstacle. */
    double distance = 0.;
    /** Area-weighted mean of the unit normals: shorter than 1 if the joint is not straight. */
    dealii::Tensor<1, dim> normal;
  };

  /** Return the sizes of all joints; zero for those that do not exist. */
  template <int dim>
  std::vector<JointSize<dim>>
  joint_sizes(const Discretization<dim> &discretization,
              const JointGeometry<dim> &geometry,
              const std::size_t n_joints);

  /**
   * Return the area of the outer faces with this label, including the extent across the plane [m²].
   */
  template <int dim>
  double
  boundary_area(const Discretization<dim> &discretization, const unsigned int label);

  /** Return the lowest and highest coordinates of all nodes. */
  template <int dim>
  std::array<dealii::Point<dim>, 2>
  extent_of(const Discretization<dim> &discretization);
} // namespace fuga

#endif
