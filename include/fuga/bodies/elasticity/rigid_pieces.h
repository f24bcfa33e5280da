// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_rigid_pieces_h
#define fuga_bodies_elasticity_rigid_pieces_h

#include <fuga/bodies/joints/contact_bars.h>

#include <array>

namespace fuga
{
  /**
   * The connected pieces of the open mesh as rigid bodies. Before anything is factorised they show
   * whether supports and closed joints hold the structure, and if not, what moves and how. A piece
   * is connected through faces; pieces that share a single vertex (or an edge) are hinged there. In
   * axisymmetry the translation along the axis is the only rigid motion.
   */
  template <int dim>
  class RigidPieces
  {
  public:
    RigidPieces(const Discretization<dim> &discretization,
                const JointedMesh &mesh,
                const std::vector<bool> &fixed);

    /** Return whether supports and these bars (all assumed rigid) exclude every rigid motion. */
    bool
    are_held_by(const ContactBars<dim> &bars) const;

    /**
     * Check that the bodies are held. @throws InputError naming a body that is not held, its motion
     * and the remedy.
     */
    void
    require_held_by(const ContactBars<dim> &bars) const;

    /** Return the number of rigid motions of the bodies that the supports allow. */
    std::size_t
    n_free_motions() const
    {
      return free_motions.size();
    }

    /**
     * Return the displacement of all nodes (entry node * dim + component) in one of these motions:
     * of the order of one, also at the corner that a rotation moves farthest.
     */
    Vector
    free_motion(const std::size_t number) const;

    /** Return the name of the body (of its first cell) that moves in one of these motions. */
    const std::string &
    moving_body(const std::size_t number) const;

  private:
    /**
     * Number of motions per piece: dim translations, then the rotations scaled by the size of the
     * piece (one in the plane; about x, y, z in space).
     */
    static constexpr unsigned int n_motions = dim == 2 ? 3 : 6;

    /** Amounts of these motions. */
    using Motion = std::array<double, n_motions>;

    /** Coefficients of one linear form of the motions of all pieces. */
    using Row = std::vector<std::pair<unsigned int, double>>;

    /**
     * Return the work of a force in @p direction, at @p arm from the center, on every motion;
     * rotations are divided by @p size.
     */
    static Motion
    work_on_motions(const dealii::Tensor<1, dim> &direction,
                    const dealii::Tensor<1, dim> &arm,
                    const double size);

    void
    find_nodes(const Discretization<dim> &discretization);

    void
    find_free_motions(const std::vector<bool> &fixed);

    Row
    displacement(const unsigned int node, const dealii::Tensor<1, dim> &direction) const;

    DenseMatrix
    gram_matrix(const ContactBars<dim> &bars) const;

    /** Return the null vectors of the Gram matrix, as columns. */
    DenseMatrix
    null_space(const ContactBars<dim> &bars) const;

    std::string
    describe(const DenseMatrix &free, const unsigned int piece) const;

    std::string
    describe(const Motion &motion, const unsigned int piece) const;

    const Discretization<dim> &discretization;
    const JointedMesh &mesh;
    /** The motions of a piece that are rigid. */
    std::vector<unsigned int> motions;
    std::vector<unsigned int> piece_of_node;
    std::vector<unsigned int> body_of_piece;
    std::vector<dealii::Point<dim>> centers;
    std::vector<double> sizes;
    DenseMatrix supports;
    /** Pieces that are hinged together move as one. */
    std::vector<unsigned int> group_of_piece;
    std::vector<std::pair<unsigned int, unsigned int>> hinges; // node, other piece
    /** A motion of one group about its center; rotations are not scaled. */
    struct FreeMotion
    {
      unsigned int group = 0;
      dealii::Point<dim> center;
      Motion motion;
    };
    std::vector<FreeMotion> free_motions;
  };
} // namespace fuga

#endif
