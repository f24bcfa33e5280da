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
   * The constraints at the joints: which degrees of freedom (node * dim + component) are sums of
   * others and of jumps, which are numbered behind them; and the jumps of all bars by the interface
   * coordinates.
   *
   * Elements that tie the same two nodes (one, or at a corner one for every straight part) have the
   * jumps along an orthonormal frame, that of the first of them, as coordinates. Where more nodes
   * meet, coordinates are offsets from one of them in global directions.
   */
  template <int dim>
  class InterfaceRows
  {
  public:
    /** Adds to @p constraints, which the caller closes. */
    InterfaceRows(const ContactBars<dim> &bars,
                  const std::vector<bool> &fixed,
                  const Vector &stiffness,
                  dealii::AffineConstraints<double> &constraints);

    /** By jump, whether a bar resists it, which makes it an interface coordinate. Others are
     * slides.
     */
    const std::vector<bool> &
    has_bar() const
    {
      return jump_has_bar;
    }

    /** Jumps of the bars from the interface coordinates. */
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
      /** If a bar resists it. */
      unsigned int coordinate;
    };

    using Cluster = std::vector<unsigned int>;

    /** Whether all elements tie the same two nodes. */
    bool
    is_pair(const Cluster &cluster) const;
    void
    add_pair(const Cluster &cluster);
    /** An orthonormal frame of all jumps that the supports allow. */
    std::vector<LocalDirection>
    frame_of_jumps(const Cluster &cluster);
    /** Adds to the frame what @p direction has besides it, if that is anything. */
    void
    add_direction(dealii::Tensor<1, dim> direction,
                  const bool by_bar,
                  std::vector<LocalDirection> &frame);
    /** Returns its number among the unknowns. */
    dealii::types::global_dof_index
    new_jump(const bool by_bar);

    void
    add_junction(const Cluster &cluster);
    void
    add_jumps(const unsigned int number, const std::map<std::size_t, unsigned int> &offset);

    void
    set_row(const std::size_t dof, const Terms &terms);

    /** u of a degree of freedom = u of another one + sign * terms. */
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
    /** By bars and interface coordinates. */
    std::vector<SparseOperator::Entry> jumps;
    bool has_junction = false;
  };
} // namespace fuga

#endif
