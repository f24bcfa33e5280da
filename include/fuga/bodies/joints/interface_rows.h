// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_interface_rows_h
#define fuga_bodies_joints_interface_rows_h

#include <deal.II/lac/affine_constraints.h>

#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/bodies/joints/contact_bars.h>

#include <map>
#include <utility>
#include <vector>

namespace fuga
{
  /**
   * The constraints at the joints: they express degrees of freedom (node * dim + component) by
   * others and by jumps, which are numbered after them; and the jumps of all bars as functions of
   * the interface coordinates.
   *
   * Elements that connect the same two nodes (one, or at a corner one for every straight part) have
   * the jumps along an orthonormal frame, that of the first of them, as coordinates. Where more
   * nodes meet, coordinates are offsets from one of them in global directions.
   */
  template <int dim>
  class InterfaceRows
  {
  public:
    /** Add the constraints to @p constraints, which the caller closes. */
    InterfaceRows(const ContactBars<dim> &bars,
                  const std::vector<bool> &fixed,
                  const Vector &stiffness,
                  dealii::AffineConstraints<double> &constraints);

    /**
     * Return for each jump whether a bar resists it, which makes it an interface coordinate. Others
     * are free slides.
     */
    const std::vector<bool> &
    has_bar() const
    {
      return jump_has_bar;
    }

    /** Return the operator that computes the jumps of the bars from the interface coordinates. */
    SparseOperator
    jump_operator() const;

  private:
    using Terms = std::vector<std::pair<dealii::types::global_dof_index, double>>;

    /** A direction of the jump of two nodes, and the number of the unknown that is the jump along
     * it.
     */
    struct LocalDirection
    {
      dealii::Tensor<1, dim> direction;
      dealii::types::global_dof_index unknown;
      /** Number of the interface coordinate, if a bar resists it. */
      unsigned int coordinate;
    };

    using Cluster = std::vector<unsigned int>;

    /** Return whether all elements connect the same two nodes. */
    bool
    is_pair(const Cluster &cluster) const;
    void
    add_pair(const Cluster &cluster);
    /** Return an orthonormal frame of all jumps that the supports allow. */
    std::vector<LocalDirection>
    frame_of_jumps(const Cluster &cluster);
    /** Add the part of @p direction that is orthogonal to the frame to it, unless it vanishes. */
    void
    add_direction(dealii::Tensor<1, dim> direction,
                  const bool by_bar,
                  std::vector<LocalDirection> &frame);
    /** Add a jump and return its number among the unknowns. */
    dealii::types::global_dof_index
    new_jump(const bool by_bar);

    void
    add_junction(const Cluster &cluster);
    void
    add_jumps(const unsigned int number, const std::map<std::size_t, unsigned int> &offset);

    void
    set_row(const std::size_t dof, const Terms &terms);

    /** Set u of a degree of freedom = u of another one + sign * terms. */
    void
    attach(const std::size_t dof, const std::size_t base, Terms terms, const double sign);

    std::vector<unsigned int>
    bars_of(const unsigned int e) const;

    const ContactBars<dim> &bars;
    const std::vector<bool> &fixed;
    const Vector &stiffness;
    dealii::AffineConstraints<double> &constraints;
    std::vector<bool> jump_has_bar;
    unsigned int interface_count = 0;
    /** Entries of the jump operator, by bars and interface coordinates. */
    std::vector<SparseOperator::Entry> jumps;
    bool has_junction = false;
  };
} // namespace fuga

#endif
