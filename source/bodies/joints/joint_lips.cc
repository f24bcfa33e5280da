// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/joints/joint_lips.h>
#include <fuga/bodies/joints/joint_order.h>
#include <fuga/bodies/point_matcher.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    template <int dim>
    using BoundaryFace = typename Discretization<dim>::BoundaryFace;

    template <int dim>
    [[noreturn]] void
    throw_unmatched(const std::string &joint, const dealii::Point<dim> &at, const std::string &lip)
    {
      throw InputError(fmt::format("Joint '{}': the {} lip at {} has no partner on the "
                                   "other lip. Both lips must have "
                                   "the same {} and the same division: give both the same "
                                   "transfinite or periodic mesh, or let "
                                   "the program open a conforming mesh along a named {}.",
                                   joint,
                                   lip,
                                   text_of(at),
                                   dim == 2 ? "line" : "surface",
                                   dim == 2 ? "line" : "surface"));
    }


    /** Return whether a joint has bodies on both sides. A joint is built as a whole, so that the
     * areas and histories of its elements remain. */
    template <int dim>
    bool
    is_there(const Discretization<dim> &discretization, const JointedMesh::Joint &joint)
    {
      const bool obstacle = joint.minus_label == JointedMesh::no_label;
      if (!discretization.lacks_faces_of(joint.plus_label) &&
          (obstacle || !discretization.lacks_faces_of(joint.minus_label)))
        return true;
      std::size_t n_plus = 0, n_minus = 0;
      for (const auto &face : discretization.boundary_faces())
        if (face.label == joint.plus_label)
          ++n_plus;
        else if (!obstacle && face.label == joint.minus_label)
          ++n_minus;
      if (n_plus == 0 || (!obstacle && n_minus == 0))
        return false;
      throw InputError(
        fmt::format("Joint '{}': the bodies along one of its sides are not all there at "
                    "the same time. A joint is built, or removed, as a whole: divide its "
                    "line into one per stage and make every part a joint.",
                    joint.name));
    }


    template <int dim>
    void
    match_nodes(const Discretization<dim> &discretization,
                const std::string &joint,
                const BoundaryFace<dim> &minus,
                MatchedFace<dim> &lip)
    {
      const std::size_t n    = lip.plus_nodes.size();
      const double tolerance = matching_tolerance * discretization.face_length(*lip.plus);
      const auto is_near     = [&](const unsigned int a, const unsigned int b) {
        return discretization.position(a).distance(discretization.position(b)) <= tolerance;
      };
      for (std::size_t k = 0; k < n; ++k)
        {
          for (std::size_t l = 0; l < n; ++l)
            if (is_near(lip.plus_nodes[k], discretization.face_node(minus, l)))
              lip.minus_nodes[k] = discretization.face_node(minus, l);
          if (lip.minus_nodes[k] == Discretization<dim>::no_node)
            throw_unmatched(joint, discretization.position(lip.plus_nodes[k]), "plus");
        }
    }


    /** Sort the faces along the joint and turn their nodes into the direction of the walk. */
    template <int dim>
    std::vector<MatchedFace<dim>>
    walk(const Discretization<dim> &discretization, const std::vector<MatchedFace<dim>> &faces)
    {
      std::vector<std::vector<dealii::Point<dim>>> corners;
      for (const auto &face : faces)
        corners.push_back(FaceMap<dim>(discretization, *face.plus).corners());
      std::vector<MatchedFace<dim>> sorted;
      for (const auto &[number, backwards] : joint_order(corners))
        {
          sorted.push_back(faces[number]);
          if (backwards)
            {
              auto &face     = sorted.back();
              face.backwards = true;
              std::reverse(face.plus_nodes.begin(), face.plus_nodes.end());
              std::reverse(face.minus_nodes.begin(), face.minus_nodes.end());
            }
        }
      return sorted;
    }
  } // namespace


  template <int dim>
  std::vector<MatchedFace<dim>>
  match_lips(const Discretization<dim> &discretization, const JointedMesh::Joint &joint)
  {
    if (!is_there(discretization, joint))
      return {};
    std::vector<MatchedFace<dim>> matched;
    std::vector<const BoundaryFace<dim> *> minus;
    std::vector<dealii::Point<dim>> centers;
    for (const auto &face : discretization.boundary_faces())
      if (face.label == joint.plus_label)
        {
          MatchedFace<dim> lip;
          lip.plus       = &face;
          const auto &on = discretization.reference_element().face(face.number);
          for (std::size_t k = 0; k < on.nodes.size(); ++k)
            lip.plus_nodes.push_back(discretization.face_node(face, k));
          lip.minus_nodes.assign(on.nodes.size(), Discretization<dim>::no_node);
          matched.push_back(std::move(lip));
        }
      else if (joint.minus_label != JointedMesh::no_label && face.label == joint.minus_label)
        {
          minus.push_back(&face);
          centers.push_back(discretization.face_center(face));
        }
    if (joint.minus_label == JointedMesh::no_label)
      return walk(discretization, matched);

    const PointMatcher<dim> matcher(centers);
    std::vector<bool> used(minus.size(), false);
    for (auto &lip : matched)
      {
        const auto center          = discretization.face_center(*lip.plus);
        const double tolerance     = matching_tolerance * discretization.face_length(*lip.plus);
        const unsigned int partner = matcher.find(center, tolerance);
        if (partner == PointMatcher<dim>::not_found || used[partner])
          throw_unmatched(joint.name, center, "plus");
        used[partner] = true;
        match_nodes(discretization, joint.name, *minus[partner], lip);
      }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i])
        throw_unmatched(joint.name, centers[i], "minus");
    return walk(discretization, matched);
  }


  template std::vector<MatchedFace<2>>
  match_lips(const Discretization<2> &, const JointedMesh::Joint &);
  template std::vector<MatchedFace<3>>
  match_lips(const Discretization<3> &, const JointedMesh::Joint &);
} // namespace fuga
