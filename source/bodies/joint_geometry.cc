// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/face_map.h>
#include <fuga/bodies/joint_geometry.h>
#include <fuga/bodies/joint_order.h>
#include <fuga/bodies/point_matcher.h>
#include <fuga/bodies/point_text.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  namespace
  {
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
  } // namespace


  template <int dim>
  JointGeometry<dim>::JointGeometry(const Discretization<dim> &space, const JointedMesh &mesh)
    : discretization(space)
  {
    for (unsigned int joint = 0; joint < mesh.joints.size(); ++joint)
      add_pairs(joint, walk(match_lips(mesh.joints[joint])));
  }


  // A joint is built as a whole, so that the areas of its elements and what they have felt remain.
  template <int dim>
  bool
  JointGeometry<dim>::is_there(const JointedMesh::Joint &joint) const
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
  auto
  JointGeometry<dim>::match_lips(const JointedMesh::Joint &joint) const -> std::vector<MatchedFace>
  {
    if (!is_there(joint))
      return {};
    std::vector<MatchedFace> matched;
    std::vector<const BoundaryFace *> minus;
    std::vector<dealii::Point<dim>> centers;
    for (const auto &face : discretization.boundary_faces())
      if (face.label == joint.plus_label)
        {
          MatchedFace lip;
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
      return matched;

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
        match_nodes(joint.name, lip, *minus[partner]);
      }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i])
        throw_unmatched(joint.name, centers[i], "minus");
    return matched;
  }


  template <int dim>
  void
  JointGeometry<dim>::match_nodes(const std::string &name,
                                  MatchedFace &lip,
                                  const BoundaryFace &minus) const
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
          throw_unmatched(name, discretization.position(lip.plus_nodes[k]), "plus");
      }
  }


  template <int dim>
  auto
  JointGeometry<dim>::walk(const std::vector<MatchedFace> &faces) const -> std::vector<MatchedFace>
  {
    std::vector<std::vector<dealii::Point<dim>>> corners;
    for (const auto &face : faces)
      corners.push_back(FaceMap<dim>(discretization, *face.plus).corners());
    std::vector<MatchedFace> sorted;
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


  // In axisymmetry the integral is exact as well: positive at every node but the one on the axis,
  // where it vanishes for degrees above 1 (Gauss-Lobatto's rule integrates N r exactly). Density is
  // relative to the first point, so that on a face of constant density equal nodes have equal
  // areas.
  template <int dim>
  Vector
  JointGeometry<dim>::node_areas(const MatchedFace &face) const
  {
    const auto &table = discretization.reference_element().face(face.plus->number);
    const FaceMap<dim> map(discretization, *face.plus);
    const double first = map.density(table.points[0]);
    Vector areas(face.plus_nodes.size(), 0.);
    for (std::size_t q = 0; q < table.weight.size(); ++q)
      {
        const double weight = table.weight[q] * (map.density(table.points[q]) / first);
        for (std::size_t k = 0; k < areas.size(); ++k)
          areas[k] += weight * table.values[q][k];
      }
    for (double &area : areas)
      area *= first;
    if (face.backwards)
      std::reverse(areas.begin(), areas.end());
    for (std::size_t k = 0; k < areas.size(); ++k)
      if (areas.size() > 2 && discretization.is_on_axis(face.plus_nodes[k]))
        areas[k] = 0.;
      else if (!(areas[k] > 0.))
        throw InputError(
          fmt::format("A face of a joint is so distorted that its node at {} gets no area. Make it "
                      "more like a parallelogram, or use degree 1.",
                      text_of(discretization.position(face.plus_nodes[k]))));
    return areas;
  }


  template <int dim>
  void
  JointGeometry<dim>::add_pairs(const unsigned int joint, const std::vector<MatchedFace> &faces)
  {
    KnownPairs known;
    for (const auto &face : faces)
      {
        const auto &table  = discretization.reference_element().face(face.plus->number);
        const auto normal  = -FaceMap<dim>(discretization, *face.plus).normal(table.points[0]);
        const Vector areas = node_areas(face);
        if (discretization.is_on_axis(face.plus_nodes.front()) &&
            discretization.is_on_axis(face.plus_nodes.back()))
          throw InputError(fmt::format(
            "A joint runs along the axis of revolution at y = {:g}, where it has no area. End it "
            "there.",
            discretization.position(face.plus_nodes.front())[1]));
        Face joint_face;
        joint_face.joint     = joint;
        joint_face.boundary  = *face.plus;
        joint_face.backwards = face.backwards;
        for (const double area : areas)
          joint_face.area += area;
        for (std::size_t k = 0; k < face.plus_nodes.size(); ++k)
          {
            const unsigned int pair =
              find_or_add(joint, face.plus_nodes[k], face.minus_nodes[k], known);
            all_pairs[pair].area += areas[k];
            all_pairs[pair].normal += (areas[k] > 0. ? areas[k] : 1.) * normal;
            joint_face.pairs.push_back(pair);
          }
        all_faces.push_back(std::move(joint_face));
      }
    if (!discretization.hanging_nodes().masters().empty())
      move_to_masters(known);
    for (const auto &entry : known)
      {
        auto &pair = all_pairs[entry.second];
        // On the axis the mirror image of the line counts too.
        if (discretization.is_on_axis(pair.plus_node))
          pair.normal[0] = 0.;
        if (pair.normal.norm() < 1e-3 * pair.area)
          throw InputError(
            fmt::format("A joint turns back on itself at {}; it has no normal there. Mend the {}.",
                        text_of(pair.position),
                        dim == 2 ? "line" : "surface"));
        pair.normal /= pair.normal.norm();
      }
  }


  template <int dim>
  unsigned int
  JointGeometry<dim>::find_or_add(const unsigned int joint,
                                  const unsigned int plus_node,
                                  const unsigned int minus_node,
                                  KnownPairs &known)
  {
    const auto [entry, is_new] =
      known.try_emplace({plus_node, minus_node}, static_cast<unsigned int>(all_pairs.size()));
    if (is_new)
      {
        NodePair<dim> pair;
        pair.joint      = joint;
        pair.plus_node  = plus_node;
        pair.minus_node = minus_node;
        pair.position   = discretization.position(plus_node);
        all_pairs.push_back(pair);
      }
    return entry->second;
  }


  // With δ_h = Σ w_k δ_k the work of a pressure on the jump of a hanging pair is one on its
  // masters: areas, and normals weighted by them, become integrals of the shape functions of the
  // space with its constraints.
  template <int dim>
  void
  JointGeometry<dim>::move_to_masters(KnownPairs &known)
  {
    std::vector<unsigned int> hanging;
    for (const auto &[nodes, pair] : known)
      if (discretization.hanging_nodes().contain(nodes.first) ||
          discretization.hanging_nodes().contain(nodes.second))
        hanging.push_back(pair);
    std::sort(hanging.begin(), hanging.end());
    for (const unsigned int pair : hanging)
      {
        find_masters(pair, known);
        for (const auto &[master, weight] : all_pairs[pair].masters)
          {
            all_pairs[master].area += weight * all_pairs[pair].area;
            all_pairs[master].normal += weight * all_pairs[pair].normal;
          }
        all_pairs[pair].area = 0.;
      }
  }


  // Lips are refined alike (mesh_refinement): a node hangs together with the one it faces, and
  // their masters face each other. One that only a cell beside the joint has becomes a pair here.
  template <int dim>
  void
  JointGeometry<dim>::find_masters(const unsigned int hanging_pair, KnownPairs &known)
  {
    const NodePair<dim> pair = all_pairs[hanging_pair]; // a copy: pairs may be added
    const auto &hanging      = discretization.hanging_nodes();
    const bool obstacle      = pair.minus_node == Discretization<dim>::no_node;
    Assert(hanging.contain(pair.plus_node) && (obstacle || hanging.contain(pair.minus_node)),
           dealii::ExcMessage("A node of a lip hangs, and its partner does not."));
    std::vector<std::pair<unsigned int, double>> masters;
    for (const auto &[plus, weight] : hanging.masters().at(pair.plus_node))
      {
        unsigned int minus = Discretization<dim>::no_node;
        if (!obstacle)
          {
            double least = std::numeric_limits<double>::infinity();
            for (const auto &candidate : hanging.masters().at(pair.minus_node))
              if (const double distance = discretization.position(plus).distance(
                    discretization.position(candidate.first));
                  distance < least)
                {
                  least = distance;
                  minus = candidate.first;
                }
          }
        masters.emplace_back(find_or_add(pair.joint, plus, minus, known), weight);
      }
    all_pairs[hanging_pair].masters = std::move(masters);
  }


  template class JointGeometry<2>;
  template class JointGeometry<3>;
} // namespace fuga
