// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/joint_geometry.h>
#include <fuga/bodies/point_matcher.h>

#include <map>

namespace fuga
{
  namespace
  {
    /** Lips count as one line if they are this close, relative to the length of a face. */
    constexpr double matching_tolerance = 1e-5;

    template <int dim>
    [[noreturn]] void
    throw_unmatched(const std::string &joint, const dealii::Point<dim> &at, const std::string &lip)
    {
      throw InputError(fmt::format("Joint '{}': the {} lip at ({:g}, {:g}) has no partner on the "
                                   "other lip. Both lips must have "
                                   "the same line and the same division: give both the same "
                                   "transfinite or periodic mesh, or let "
                                   "the program open a conforming mesh along a named line.",
                                   joint,
                                   lip,
                                   at[0],
                                   at[1]));
    }

    /** Faces as edges of a graph whose nodes are places; removes edges as they are walked. */
    template <int dim>
    class Walker
    {
    public:
      Walker(const std::vector<std::pair<dealii::Point<dim>, dealii::Point<dim>>> &edges)
      {
        std::vector<dealii::Point<dim>> ends;
        for (const auto &edge : edges)
          ends.insert(ends.end(), {edge.first, edge.second});
        const PointMatcher<dim> matcher(ends);
        for (unsigned int e = 0; e < edges.size(); ++e)
          {
            const double tolerance = matching_tolerance * edges[e].first.distance(edges[e].second);
            places.push_back({{matcher.find(edges[e].first, tolerance),
                               matcher.find(edges[e].second, tolerance)}});
            for (const unsigned int place : places.back())
              {
                edges_at[place].push_back(e);
                position[place] = ends[place];
                extent          = std::max(extent, ends[place].distance(ends.front()));
              }
          }
        walked.assign(edges.size(), false);
      }

      /** Edge numbers in walking order, and whether each is walked backwards. */
      std::vector<std::pair<unsigned int, bool>>
      walk()
      {
        std::vector<std::pair<unsigned int, bool>> order;
        while (order.size() < walked.size())
          {
            unsigned int at = start();
            for (unsigned int e; (e = next_edge(at)) != PointMatcher<dim>::not_found;)
              {
                const bool backwards = places[e][0] != at;
                walked[e]            = true;
                order.emplace_back(e, backwards);
                at = places[e][backwards ? 0 : 1];
              }
          }
        return order;
      }

    private:
      unsigned int
      next_edge(const unsigned int place) const
      {
        for (const unsigned int e : edges_at.at(place))
          if (!walked[e])
            return e;
        return PointMatcher<dim>::not_found;
      }

      /** The first free end; in a closed line the first place. */
      unsigned int
      start() const
      {
        unsigned int best       = PointMatcher<dim>::not_found;
        std::size_t best_degree = 0;
        for (const auto &[place, edges] : edges_at)
          {
            std::size_t degree = 0;
            for (const unsigned int e : edges)
              degree += walked[e] ? 0 : 1;
            const bool is_end = degree == 1, best_is_end = best_degree == 1;
            if (degree > 0 && (best_degree == 0 || (is_end && !best_is_end) ||
                               (is_end == best_is_end && is_before(place, best))))
              {
                best        = place;
                best_degree = degree;
              }
          }
        return best;
      }

      bool
      is_before(const unsigned int a, const unsigned int b) const
      {
        const auto offset = position.at(a) - position.at(b);
        for (unsigned int c = 0; c < dim; ++c)
          if (std::abs(offset[c]) > 1e-9 * extent)
            return offset[c] < 0.;
        return false;
      }

      std::vector<std::array<unsigned int, 2>> places;
      std::map<unsigned int, std::vector<unsigned int>> edges_at;
      std::map<unsigned int, dealii::Point<dim>> position;
      std::vector<bool> walked;
      double extent = 0.;
    };
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
    const bool same_way = is_near(lip.plus_nodes[0], discretization.face_node(minus, 0));
    for (std::size_t k = 0; k < n; ++k)
      {
        lip.minus_nodes[k] = discretization.face_node(minus, same_way ? k : n - 1 - k);
        if (!is_near(lip.plus_nodes[k], lip.minus_nodes[k]))
          throw_unmatched(name, discretization.position(lip.plus_nodes[k]), "plus");
      }
  }


  template <int dim>
  auto
  JointGeometry<dim>::walk(const std::vector<MatchedFace> &faces) const -> std::vector<MatchedFace>
  {
    std::vector<std::pair<dealii::Point<dim>, dealii::Point<dim>>> edges;
    for (const auto &face : faces)
      edges.emplace_back(discretization.position(face.plus_nodes.front()),
                         discretization.position(face.plus_nodes.back()));
    std::vector<MatchedFace> sorted;
    if (!edges.empty())
      for (const auto &[number, backwards] : Walker<dim>(edges).walk())
        {
          sorted.push_back(faces[number]);
          if (backwards)
            {
              auto &face = sorted.back();
              std::reverse(face.plus_nodes.begin(), face.plus_nodes.end());
              std::reverse(face.minus_nodes.begin(), face.minus_nodes.end());
            }
        }
    return sorted;
  }


  // In axisymmetry the integral is exact as well: positive at every node but the one on the axis,
  // where it vanishes for degrees above 1 (Gauss-Lobatto's rule integrates N r exactly).
  template <int dim>
  Vector
  JointGeometry<dim>::node_areas(const MatchedFace &face) const
  {
    const auto &table   = discretization.reference_element().face(face.plus->number);
    const auto first    = discretization.position(face.plus_nodes.front());
    const auto along    = discretization.position(face.plus_nodes.back()) - first;
    const double length = discretization.face_length(*face.plus);
    Vector areas(face.plus_nodes.size(), 0.);
    // Nodes and points lie symmetrically: the direction of the walk does not matter.
    for (std::size_t k = 0; k < areas.size(); ++k)
      if (!discretization.is_axisymmetric())
        areas[k] = discretization.extent_across(first) * length * table.node_weights[k];
      else if (areas.size() == 2 || !discretization.is_on_axis(face.plus_nodes[k]))
        for (std::size_t q = 0; q < table.weight.size(); ++q)
          areas[k] += length * table.weight[q] * table.values[q][k] *
                      discretization.extent_across(first + table.position[q] * along);
    return areas;
  }


  template <int dim>
  void
  JointGeometry<dim>::add_pairs(const unsigned int joint, const std::vector<MatchedFace> &faces)
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> known;
    for (const auto &face : faces)
      {
        const auto normal  = -discretization.outer_normal(*face.plus);
        const Vector areas = node_areas(face);
        if (discretization.is_on_axis(face.plus_nodes.front()) &&
            discretization.is_on_axis(face.plus_nodes.back()))
          throw InputError(fmt::format(
            "A joint runs along the axis of revolution at y = {:g}, where it has no area. End it "
            "there.",
            discretization.position(face.plus_nodes.front())[1]));
        Face joint_face;
        joint_face.joint = joint;
        for (std::size_t k = 0; k < face.plus_nodes.size(); ++k)
          {
            const auto [entry, is_new] =
              known.try_emplace({face.plus_nodes[k], face.minus_nodes[k]}, all_pairs.size());
            if (is_new)
              {
                NodePair<dim> pair;
                pair.joint      = joint;
                pair.plus_node  = face.plus_nodes[k];
                pair.minus_node = face.minus_nodes[k];
                pair.position   = discretization.position(pair.plus_node);
                all_pairs.push_back(pair);
              }
            all_pairs[entry->second].area += areas[k];
            all_pairs[entry->second].normal += (areas[k] > 0. ? areas[k] : 1.) * normal;
            joint_face.pairs.push_back(entry->second);
          }
        all_faces.push_back(std::move(joint_face));
      }
    for (const auto &entry : known)
      {
        auto &pair = all_pairs[entry.second];
        // On the axis the mirror image of the line counts too.
        if (discretization.is_on_axis(pair.plus_node))
          pair.normal[0] = 0.;
        if (pair.normal.norm() < 1e-3 * pair.area)
          throw InputError(fmt::format(
            "A joint turns back on itself at ({:g}, {:g}); it has no normal there. Mend the line.",
            pair.position[0],
            pair.position[1]));
        pair.normal /= pair.normal.norm();
      }
  }


  template class JointGeometry<2>;
} // namespace fuga
