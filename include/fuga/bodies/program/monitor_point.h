// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_monitor_point_h
#define fuga_bodies_program_monitor_point_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/space/discretization.h>

#include <map>

namespace fuga
{
  /**
   * The position of a monitor in the mesh: its cell and the shape functions there. It does not move
   * while its body does not exist.
   */
  template <int dim>
  class MonitorPoint
  {
  public:
    /**
     * @throws InputError if the point lies outside of all bodies (or of the one that is named), if
     * a name does not denote a point, and if the point lies on a joint and its lip is not
     * specified.
     */
    MonitorPoint(const Discretization<dim> &discretization,
                 const JointedMesh &mesh,
                 const MonitorDefinition &definition);

    const dealii::Point<dim> &
    position() const
    {
      return point;
    }

    /**
     * Return the nodal forces of a unit force at the point: their work on u is the displacement of
     * the point. Entry node * dim + component.
     */
    Vector
    unit_force(const unsigned int component) const;

    /**
     * Return the nodal forces whose work on u is ∂u_i/∂x_j at the point, i = @p component, j =
     * @p direction: the mean over the cells of the body around the point.
     */
    Vector
    gradient_force(const unsigned int component, const unsigned int direction) const;

    /** Return the index of the body. */
    unsigned int
    body() const
    {
      return its_body;
    }

  private:
    struct NodeShare
    {
      unsigned int node = 0;
      double share      = 0.;
    };

    using Shares = std::vector<NodeShare>;

    /** Replace the shares of hanging nodes by those of their masters. */
    void
    replace_hanging_nodes(Shares &of_nodes) const;

    dealii::Point<dim>
    find_position(const JointedMesh &mesh, const MonitorDefinition &definition) const;
    Shares
    shares_in(const std::size_t cell, const dealii::Point<dim> &in_reference_cell) const;
    void
    add_gradients(const std::size_t cell, const std::vector<dealii::Tensor<1, dim>> &of_cell);
    bool
    is_in_absent_body(const unsigned int body) const;
    [[noreturn]] void
    fail_outside(const MonitorDefinition &definition) const;

    const Discretization<dim> &discretization;
    dealii::Point<dim> point;
    Shares shares;
    unsigned int its_body = 0;
    std::size_t n_cells   = 0;
    /** Sums of the gradients over the cells, by node. */
    std::map<unsigned int, dealii::Tensor<1, dim>> gradients;
  };
} // namespace fuga

#endif
