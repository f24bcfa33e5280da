// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_joint_geometry_h
#define fuga_bodies_joints_joint_geometry_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/joints/joint_lips.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace fuga
{
  /** Two nodes that face each other across a straight part of a joint, or one node and the rigid
   * obstacle. */
  template <int dim>
  struct NodePair
  {
    unsigned int joint     = 0;
    unsigned int plus_node = 0;
    /** Node on the minus side; Discretization::no_node for the obstacle. */
    unsigned int minus_node = 0;
    /** Number of the straight part among those that meet at these nodes; 0 except at corners. */
    unsigned int part = 0;
    /** Unit vector from the minus to the plus side. */
    dealii::Tensor<1, dim> normal;
    dealii::Point<dim> position;
    /**
     * Tributary area, including the extent across the plane; 0 on the axis of revolution for
     * degrees above 1.
     */
    double area = 0.;
    /**
     * The pairs with which a pair of hanging nodes moves, and their weights. It has no area of its
     * own, as forces on hanging nodes go to their masters.
     */
    std::vector<std::pair<unsigned int, double>> masters;
  };

  /** Return the other vector of the local frame: (tangent, normal) is right-handed like (x, y). */
  inline std::array<dealii::Tensor<1, 2>, 1>
  tangents(const dealii::Tensor<1, 2> &normal)
  {
    std::array<dealii::Tensor<1, 2>, 1> t;
    t[0][0] = normal[1];
    t[0][1] = -normal[0];
    return t;
  }

  /**
   * Return the other vectors of the local frame: (t1, t2, normal) is right-handed like (x, y, z),
   * and t1 is the direction of x projected onto the plane of the joint; if the normal is within
   * 25.8 degrees of x (|n_x| > 0.9), that of y.
   */
  inline std::array<dealii::Tensor<1, 3>, 2>
  tangents(const dealii::Tensor<1, 3> &normal)
  {
    dealii::Tensor<1, 3> t;
    t[std::abs(normal[0]) > 0.9 ? 1 : 0] = 1.;
    t -= (t * normal) * normal;
    t /= t.norm();
    return {{t, dealii::cross_product_3d(normal, t)}};
  }

  /**
   * The node pairs of all joints. The lips are matched face by face, not node by node, so that
   * where joints cross every pair of copies that really faces each other is found. At a corner
   * (JointedMesh::Joint::corner_angle) the nodes have a pair for every straight part, with the area
   * and the normal of the faces of this part alone. Within a part the normal is the average of the
   * neighbouring faces weighted by tributary areas.
   */
  template <int dim>
  class JointGeometry
  {
  public:
    /** One face of a joint. */
    struct Face
    {
      unsigned int joint = 0;
      /**
       * Indices of the pairs; in the plane in the direction of numbering, in space in the order of
       * the nodes of the face.
       */
      std::vector<unsigned int> pairs;
      /** The face on the plus lip. */
      typename Discretization<dim>::BoundaryFace boundary;
      double area = 0.;
      /** Whether the direction of numbering is opposite to that of the face. */
      bool backwards = false;

      /** Return the pair at node @p k of the boundary face. */
      unsigned int
      pair_of_node(const std::size_t k) const
      {
        return pairs[backwards ? pairs.size() - 1 - k : k];
      }
    };

    /** @throws InputError with coordinates where the lips do not match. */
    JointGeometry(const Discretization<dim> &discretization, const JointedMesh &mesh);

    /**
     * Return the pairs by joints; in the plane from one end of each joint to the other: the one
     * with the smaller x, then y, first; in space by their faces in the order of the x, then y,
     * then z of their centers.
     */
    const std::vector<NodePair<dim>> &
    pairs() const
    {
      return all_pairs;
    }

    const std::vector<Face> &
    faces() const
    {
      return all_faces;
    }

  private:
    using Normal = dealii::Tensor<1, dim>;

    /** A pair, and the normals of the faces to which it belongs. */
    struct KnownPair
    {
      unsigned int index = 0;
      std::vector<Normal> normals;
    };

    /** The pairs of one joint by their nodes on the plus and the minus side, and by their parts. */
    using Nodes      = std::pair<unsigned int, unsigned int>;
    using KnownPairs = std::map<Nodes, std::vector<KnownPair>>;

    void
    add_joint(const unsigned int joint, const JointedMesh::Joint &definition);

    /** Return the parts to which the faces belong, for every node of each. */
    std::vector<std::vector<unsigned int>>
    parts_of_faces(const std::vector<MatchedFace<dim>> &faces, const double corner_angle) const;

    /** Return the normal at the first point, from the minus to the plus side. */
    Normal
    normal_of(const MatchedFace<dim> &face) const;

    /** Return ∫ N over the area of a face, for all its nodes. */
    Vector
    node_areas(const MatchedFace<dim> &face) const;

    void
    add_face(const unsigned int joint,
             const MatchedFace<dim> &face,
             const std::vector<unsigned int> &parts,
             KnownPairs &known);

    /** Return the pair of a part of the nodes; parts are created in the order of their numbers. */
    KnownPair &
    find_or_add(const unsigned int joint,
                const Nodes &nodes,
                const unsigned int part,
                KnownPairs &known);

    /** Move the areas of hanging pairs to their masters. */
    void
    move_to_masters(const double corner_angle, KnownPairs &known);

    /** Find the pairs with which a hanging pair moves. */
    void
    find_masters(const KnownPair &hanging_pair, const double corner_angle, KnownPairs &known);

    /**
     * Return the part of the nodes that contains the normals of a hanging pair; a new one if there
     * is none.
     */
    unsigned int
    part_of_master(const std::vector<KnownPair> &of_master,
                   const std::vector<Normal> &normals,
                   const double corner_angle) const;

    void
    finish_normal(NodePair<dim> &pair) const;

    const Discretization<dim> &discretization;
    std::vector<NodePair<dim>> all_pairs;
    std::vector<Face> all_faces;
  };
} // namespace fuga

#endif
