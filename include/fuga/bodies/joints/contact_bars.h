// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_contact_bars_h
#define fuga_bodies_joints_contact_bars_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/contact/contact_element.h>

#include <string>

namespace fuga
{
  /**
   * The contact elements of all joints and their bars. A bar whose jump the supports exclude does
   * not exist; neither does an element without normal bar, at a tip inside a body, or without area
   * on the axis of revolution.
   */
  template <int dim>
  class ContactBars
  {
  public:
    static constexpr unsigned int no_element = static_cast<unsigned int>(-1);

    /** One bar: its jump is (u⁺ - u⁻)·direction. */
    struct Bar
    {
      unsigned int plus_node  = 0;
      unsigned int minus_node = 0;
      dealii::Tensor<1, dim> direction;
    };

    /** Two degrees of freedom that face each other and are both held. */
    struct HeldPair
    {
      unsigned int plus_node  = 0;
      unsigned int minus_node = 0;
      unsigned int component  = 0;
    };

    /**
     * @p fixed marks held degrees of freedom, node * dim + component; @p frictionless marks joints
     * without tangential bars, except at the nodes where they cross or touch others.
     * @throws InputError if a support holds both lips in a direction oblique to the joint.
     */
    ContactBars(const JointGeometry<dim> &geometry,
                const JointedMesh &mesh,
                const std::vector<bool> &fixed,
                const std::vector<bool> &frictionless);

    /**
     * Return the elements with geometry and numbers only; the laws have to be added by the caller.
     */
    const std::vector<ContactElement> &
    elements() const
    {
      return all_elements;
    }

    const NodePair<dim> &
    pair_of_element(const std::size_t element) const
    {
      return geometry.pairs()[pairs[element]];
    }

    /**
     * Return the tangents of an element: those of its pair, or, if the supports exclude a jump
     * along the first but not along the second, both turned by a right angle.
     */
    const std::array<dealii::Tensor<1, dim>, dim - 1> &
    tangents_of_element(const std::size_t element) const
    {
      return its_tangents[element];
    }

    /** Return the number of its first tangents along which the supports allow a jump. */
    unsigned int
    n_free_tangents(const std::size_t element) const
    {
      return free_tangents[element];
    }

    const std::vector<Bar> &
    bars() const
    {
      return all_bars;
    }

    const std::vector<HeldPair> &
    held_pairs() const
    {
      return all_held_pairs;
    }

    /** Contact elements, with their weights. */
    using Shares = std::vector<std::pair<unsigned int, double>>;

    /**
     * Return the elements that make up the jump of a pair of the geometry: its element; for a
     * hanging pair those of its masters; none where lips are bonded or held.
     */
    Shares
    shares_of_pair(const unsigned int pair) const;

    /** Return the jump of every bar; @p u has entries node * dim + component. */
    Vector
    jumps(const Vector &u) const;

    /** Add @p factor times the nodal forces Gᵀ p. */
    void
    add_forces(const double factor, const Vector &p, Vector &forces) const;

    /** Return one line per joint with elements left out. */
    const std::vector<std::string> &
    report() const
    {
      return lines;
    }

  private:
    /** The part of the jump of a pair that the supports allow. */
    struct Jump
    {
      bool normal = true;
      std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
      unsigned int n_free_tangents = dim - 1;
    };

    Jump
    possible_jump(const NodePair<dim> &pair,
                  const std::string &joint,
                  const std::vector<bool> &fixed);

    void
    add_element(const unsigned int pair,
                const unsigned int number,
                const Jump &jump,
                const bool tangential_bars);

    const JointGeometry<dim> &geometry;
    std::vector<ContactElement> all_elements;
    std::vector<unsigned int> pairs;
    std::vector<unsigned int> pair_elements;
    std::vector<std::array<dealii::Tensor<1, dim>, dim - 1>> its_tangents;
    std::vector<unsigned int> free_tangents;
    std::vector<Bar> all_bars;
    std::vector<HeldPair> all_held_pairs;
    std::vector<std::string> lines;
  };
} // namespace fuga

#endif
