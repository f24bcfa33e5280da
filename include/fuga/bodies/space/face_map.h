// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_face_map_h
#define fuga_bodies_space_face_map_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * One boundary face as the image of its reference: positions, areas and normals for integrals.
   */
  template <int dim>
  class FaceMap
  {
  public:
    using BoundaryFace = typename Discretization<dim>::BoundaryFace;
    using FacePoint    = typename ReferenceElement<dim>::FacePoint;

    /** A straight line in the reference of the face. */
    struct Line
    {
      FacePoint begin, end;
      /**
       * Measure of the part of the face that the line represents, per unit of the distance from its
       * begin to its end.
       */
      double weight = 1.;

      FacePoint
      at(const double position) const
      {
        return begin + position * (end - begin);
      }
    };

    FaceMap(const Discretization<dim> &discretization, const BoundaryFace &face);

    dealii::Point<dim>
    point(const FacePoint &at) const;

    /** Return the area per measure of the reference, including the extent across the plane. */
    double
    density(const FacePoint &at) const;

    /** Return the unit normal that points out of the body. */
    dealii::Tensor<1, dim>
    normal(const FacePoint &at) const;

    /** Return the values of the shape functions of the nodes of the face. */
    std::vector<double>
    values(const FacePoint &at) const
    {
      return space.reference_element().face_values(face.number, at);
    }

    std::size_t
    n_nodes() const
    {
      return space.reference_element().face(face.number).nodes.size();
    }

    const std::vector<dealii::Point<dim>> &
    corners() const
    {
      return its_corners;
    }

    /** Return the heights of the corners: y in the plane, z in space. */
    Vector
    heights() const;

    /**
     * Interpolate (bi)linearly between the values at the corners, which are reproduced exactly
     * there.
     */
    double
    interpolate(const Vector &at_corners, const FacePoint &at) const;

    /**
     * Return lines that sweep the face, for integrands that have corners where one of some affine
     * functions of the position vanishes, which are given by their values at the corners of the
     * face. The lines run in the direction in which the first of them changes most; across them
     * Gauss' rule with @p n_points is applied between the positions where a corner of the integrand
     * meets an edge of the face. In the plane the face is the only line.
     */
    std::vector<Line>
    lines(const std::vector<Vector> &corner_functions, const unsigned int n_points) const;

  private:
    dealii::Tensor<1, dim>
    tangent(const FacePoint &at, const unsigned int coordinate) const;

    const Discretization<dim> &space;
    const BoundaryFace face;
    std::vector<dealii::Point<dim>> its_corners;
  };
} // namespace fuga

#endif
