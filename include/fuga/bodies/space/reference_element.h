// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_reference_element_h
#define fuga_bodies_space_reference_element_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class FiniteElement;
  template <int dim, int spacedim>
  class Mapping;
  template <int dim>
  class Quadrature;
  class ReferenceCell;
} // namespace dealii

namespace fuga
{
  /**
   * Everything that depends only on the kind of element: the scalar Lagrange element, the positions
   * of its nodes, and tables of its faces, whose nodes joints need in an order of their own. This
   * is the only place where finite element, mapping and quadrature are chosen from the shape of the
   * cells (a tensor Gauss rule on a triangle is accepted by deal.II and doubles its area).
   *
   * The geometry of a cell is linear (bilinear, trilinear) in its corners, whatever the degree. The
   * corners are the first nodes of the cell.
   */
  template <int dim>
  class ReferenceElement
  {
  public:
    /** Coordinates on a face: (0, 1), the unit square, or the triangle (0,0), (1,0), (0,1). */
    using FacePoint = dealii::Point<dim - 1>;

    /**
     * Tables of one face; weights sum to the measure of its reference: 1, or 1/2 for a triangle.
     */
    struct Face
    {
      /** The nodes on the face, by their last coordinate on it, then by the one before: in the
       *  plane from its first corner to its second one. */
      std::vector<unsigned int> nodes;
      /** Positions of the corners in `nodes`. */
      std::vector<unsigned int> corners;
      std::vector<FacePoint> corner_points;
      std::vector<FacePoint> points;
      std::vector<double> weight;
      /** Values of the shape functions of `nodes`, values[q][k]. */
      std::vector<std::vector<double>> values;
    };

    /**
     * @p with_radius tells whether integrands have a radius as factor.
     * @throws InputError if there is no such element, with the degrees that exist.
     */
    ReferenceElement(const dealii::ReferenceCell &shape,
                     const unsigned int degree,
                     const bool with_radius = false);

    ~ReferenceElement();

    const dealii::FiniteElement<dim, dim> &
    scalar_element() const
    {
      return *element;
    }

    /** Return the (bi)linear mapping. */
    const dealii::Mapping<dim, dim> &
    mapping() const;

    std::size_t
    n_nodes() const
    {
      return node_geometry.size();
    }

    std::size_t
    n_corners() const
    {
      return node_geometry.front().size();
    }

    /** Return the (bi)linear functions of the corners at node @p i. */
    const std::vector<double> &
    geometry_at_node(const std::size_t i) const
    {
      return node_geometry[i];
    }

    /**
     * Return a quadrature that is exact for the stiffness of affine cells and for constant loads;
     * with a radius as factor, for constant loads and for the forces of a constant stress.
     */
    const dealii::Quadrature<dim> &
    quadrature() const
    {
      return *rule;
    }

    const Face &
    face(const unsigned int number) const
    {
      return faces[number];
    }

    /** Return the values of the shape functions of face(number).nodes. */
    std::vector<double>
    face_values(const unsigned int number, const FacePoint &point) const;

    /** Return the values of the (bi)linear functions of the corners of a face. */
    std::vector<double>
    corner_values(const unsigned int number, const FacePoint &point) const;

    /**
     * Return the derivatives of these functions with respect to one of the coordinates on the face.
     */
    std::vector<double>
    corner_derivatives(const unsigned int number,
                       const FacePoint &point,
                       const unsigned int coordinate) const;

  private:
    void
    tabulate_face(const unsigned int number, const unsigned int degree);

    void
    find_face_nodes(const unsigned int number);

    std::unique_ptr<dealii::FiniteElement<dim, dim>> element;
    std::unique_ptr<dealii::Quadrature<dim>> rule;
    std::vector<std::vector<double>> node_geometry;
    std::vector<Face> faces;
  };
} // namespace fuga

#endif
