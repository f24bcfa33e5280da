// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_interface_coordinates_h
#define fuga_bodies_joints_interface_coordinates_h

#include <fuga/bodies/joints/interface_rows.h>

#include <optional>

namespace fuga
{
  /**
   * The change of variables that replaces one lip by the jumps: u⁺ = u⁻ + Q δ, or u⁻ = u⁺ - Q δ, so
   * that the softer lip moves: after the elimination, nothing but rounding would be left of the
   * stiffness of a stiff lip on a soft body. In the new coordinates δ = 0 is the bonded structure,
   * so that everything but the jumps can be eliminated even if a body is held only by the joints.
   *
   * Every degree of freedom (entry node * dim + component) is a sum of coordinates with factors,
   * plus a prescribed part: that of the support to which it is attached. Coordinates are numbered
   * from 0; the interface coordinates come last. Where more than two nodes meet (joints cross or
   * touch) the interface coordinates are offsets from one of the nodes in global directions; there,
   * and where several elements connect the same nodes (the corner of a joint), the jump operator is
   * not the identity. Hanging nodes have the coordinates of their masters.
   *
   * All of this is stored in deal.II's AffineConstraints, whose unknowns are the degrees of freedom
   * followed by the jumps. Unknowns without constraint are coordinates, except for the supports,
   * which have values.
   */
  template <int dim>
  class InterfaceCoordinates
  {
  public:
    struct Term
    {
      unsigned int coordinate = 0;
      double factor           = 0.;
    };

    /** @p stiffness is given by node, in any unit; the nodes with the smaller one move. */
    InterfaceCoordinates(const Discretization<dim> &discretization,
                         const ContactBars<dim> &bars,
                         const std::vector<bool> &fixed,
                         const Vector &stiffness);

    unsigned int
    size() const
    {
      return n_coordinates;
    }

    unsigned int
    n_interface() const
    {
      return interface_count;
    }

    unsigned int
    first_interface_coordinate() const
    {
      return n_coordinates - interface_count;
    }

    /** Return whether all degrees of freedom of the node are coordinates themselves. */
    bool
    is_plain(const std::size_t node) const
    {
      for (unsigned int c = 0; c < dim; ++c)
        if (numbers[node * dim + c] < 0)
          return false;
      return true;
    }

    /** Return the coordinate that equals a degree of freedom of a plain node. */
    unsigned int
    plain_coordinate(const std::size_t dof) const
    {
      return static_cast<unsigned int>(numbers[dof]);
    }

    /** Return the coordinate that equals a degree of freedom, if it is one. */
    std::optional<unsigned int>
    coordinate_of(const std::size_t dof) const
    {
      if (numbers[dof] < 0)
        return {};
      return plain_coordinate(dof);
    }

    /** Set @p terms to those of a degree of freedom (none if it is held). */
    void
    terms_of(const std::size_t dof, std::vector<Term> &terms) const;

    /** Return C y + u, where u may be empty. */
    Vector
    distribute(const double *y, const Vector &u) const;

    /** Return Cᵀ f. */
    Vector
    gather(const Vector &forces) const;

    /** Assign the prescribed displacement of a support to the degrees of freedom attached to it. */
    void
    extend_prescribed(Vector &prescribed) const;

    /** Return the operator that computes the jumps of the bars from the interface coordinates. */
    const SparseOperator &
    jump_operator() const
    {
      return B;
    }

  private:
    void
    hang_nodes(const HangingNodes<dim> &hanging, const std::vector<bool> &fixed);

    void
    number(const std::vector<bool> &fixed, const std::vector<bool> &has_bar);

    dealii::AffineConstraints<double> constraints;
    /** Coordinate of each unknown; -1 if it is constrained or held. */
    std::vector<int> numbers;
    std::size_t n_dofs           = 0;
    unsigned int n_coordinates   = 0;
    unsigned int interface_count = 0;
    SparseOperator B;
  };
} // namespace fuga

#endif
