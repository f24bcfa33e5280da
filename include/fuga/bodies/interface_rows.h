// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_interface_rows_h
#define fuga_bodies_interface_rows_h

#include <fuga/bodies/contact_bars.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace fuga
{
  /**
   * Which of the degrees of freedom at the joints are sums of coordinates, before the coordinates
   * have their final numbers (InterfaceCoordinates), and the jumps of all bars by the interface
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
    /** What a term refers to. */
    enum class Kind
    {
      interface,
      /** A jump without bar. */
      slide,
      /** A degree of freedom, node * dim + component. */
      dof
    };

    struct Term
    {
      Kind kind;
      std::size_t index;
      double factor;
    };

    /** Mark of a degree of freedom that is a coordinate itself. */
    static constexpr int unset = std::numeric_limits<int>::max();

    /** @p rows: unset, or -1 for what is held or hangs; gets -1 - number of its special row for
     * every degree of freedom that moves with another one. */
    InterfaceRows(const ContactBars<dim> &bars,
                  const std::vector<bool> &fixed,
                  const Vector &stiffness,
                  std::vector<int> &rows);

    unsigned int
    n_interface() const
    {
      return interface_count;
    }

    unsigned int
    n_slides() const
    {
      return slide_count;
    }

    /** Special row 0 has no terms. */
    const std::vector<std::vector<Term>> &
    special() const
    {
      return special_rows;
    }

    /** Pairs of a degree of freedom and the support it hangs on. */
    const std::vector<std::pair<std::size_t, std::size_t>> &
    hangs_on() const
    {
      return supports;
    }

    /** Jumps of the bars from the interface coordinates; empty if it is the identity. */
    DenseMatrix
    jump_operator() const;

  private:
    struct JumpEntry
    {
      unsigned int bar, coordinate;
      double factor;
    };

    /** A direction of the jump of two nodes, and the coordinate that is the jump along it. */
    struct LocalDirection
    {
      dealii::Tensor<1, dim> direction;
      Term term;
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
    /** Adds to the frame what @p direction has besides it; false if that is nothing. */
    static bool
    add_direction(dealii::Tensor<1, dim> direction,
                  const Term &term,
                  std::vector<LocalDirection> &frame);

    void
    add_junction(const Cluster &cluster);
    void
    add_jumps(const unsigned int number, const std::map<std::size_t, unsigned int> &offset);

    void
    set_row(const std::size_t dof, std::vector<Term> terms);
    void
    attach(const std::size_t dof,
           const std::size_t base,
           std::vector<Term> terms,
           const double sign);

    std::vector<unsigned int>
    bars_of(const unsigned int e) const;

    const ContactBars<dim> &bars;
    const std::vector<bool> &fixed;
    const Vector &stiffness;
    std::vector<int> &rows;
    unsigned int interface_count = 0, slide_count = 0;
    std::vector<std::vector<Term>> special_rows = {{}};
    std::vector<std::pair<std::size_t, std::size_t>> supports;
    std::vector<JumpEntry> jumps;
    bool has_junction = false;
  };
} // namespace fuga

#endif
