// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/joints/joint_corners.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  template <int dim>
  JointGeometry<dim>::JointGeometry(const Discretization<dim> &space, const JointedMesh &mesh)
    : discretization(space)
  {
    for (unsigned int joint = 0; joint < mesh.joints.size(); ++joint)
      add_joint(joint, mesh.joints[joint]);
  }


  template <int dim>
  void
  JointGeometry<dim>::add_joint(const unsigned int joint, const JointedMesh::Joint &definition)
  {
    const std::vector<MatchedFace<dim>> faces = match_lips(discretization, definition);
    const auto parts                          = parts_of_faces(faces, definition.corner_angle);
    KnownPairs known;
    for (std::size_t f = 0; f < faces.size(); ++f)
      add_face(joint, faces[f], parts[f], known);
    if (!discretization.hanging_nodes().masters().empty())
      move_to_masters(definition.corner_angle, known);
    for (const auto &of_nodes : known)
      for (const KnownPair &pair : of_nodes.second)
        finish_normal(all_pairs[pair.index]);
  }


  template <int dim>
  std::vector<std::vector<unsigned int>>
  JointGeometry<dim>::parts_of_faces(const std::vector<MatchedFace<dim>> &faces,
                                     const double corner_angle) const
  {
    std::map<Nodes, std::vector<Normal>> normals;
    for (const auto &face : faces)
      for (std::size_t k = 0; k < face.plus_nodes.size(); ++k)
        normals[{face.plus_nodes[k], face.minus_nodes[k]}].push_back(normal_of(face));
    std::map<Nodes, std::vector<unsigned int>> parts_at;
    for (const auto &[nodes, around] : normals)
      parts_at[nodes] = straight_parts(around, corner_angle);
    std::map<Nodes, std::size_t> n_read;
    std::vector<std::vector<unsigned int>> parts(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t k = 0; k < faces[f].plus_nodes.size(); ++k)
        {
          const Nodes nodes(faces[f].plus_nodes[k], faces[f].minus_nodes[k]);
          parts[f].push_back(parts_at[nodes][n_read[nodes]++]);
        }
    return parts;
  }


  template <int dim>
  dealii::Tensor<1, dim>
  JointGeometry<dim>::normal_of(const MatchedFace<dim> &face) const
  {
    const auto &table = discretization.reference_element().face(face.plus->number);
    return -FaceMap<dim>(discretization, *face.plus).normal(table.points[0]);
  }


  // In axisymmetry the integral is exact as well: it is positive at every node except for the one
  // on the axis, where it vanishes for degrees above 1 (Gauss-Lobatto's rule integrates N r
  // exactly). Density is relative to the first point, so that equal nodes have equal areas on a
  // face of constant density.
  template <int dim>
  Vector
  JointGeometry<dim>::node_areas(const MatchedFace<dim> &face) const
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
  JointGeometry<dim>::add_face(const unsigned int joint,
                               const MatchedFace<dim> &face,
                               const std::vector<unsigned int> &parts,
                               KnownPairs &known)
  {
    const Normal normal = normal_of(face);
    const Vector areas  = node_areas(face);
    if (discretization.is_on_axis(face.plus_nodes.front()) &&
        discretization.is_on_axis(face.plus_nodes.back()))
      throw InputError(fmt::format(
        "A joint runs along the axis of revolution at y = {:g}, where it has no area. End "
        "it there.",
        discretization.position(face.plus_nodes.front())[1]));
    Face joint_face;
    joint_face.joint     = joint;
    joint_face.boundary  = *face.plus;
    joint_face.backwards = face.backwards;
    for (const double area : areas)
      joint_face.area += area;
    for (std::size_t k = 0; k < face.plus_nodes.size(); ++k)
      {
        KnownPair &pair =
          find_or_add(joint, {face.plus_nodes[k], face.minus_nodes[k]}, parts[k], known);
        pair.normals.push_back(normal);
        all_pairs[pair.index].area += areas[k];
        all_pairs[pair.index].normal += (areas[k] > 0. ? areas[k] : 1.) * normal;
        joint_face.pairs.push_back(pair.index);
      }
    all_faces.push_back(std::move(joint_face));
  }


  template <int dim>
  void
  JointGeometry<dim>::finish_normal(NodePair<dim> &pair) const
  {
    // On the axis the mirror image of the line counts as well.
    if (discretization.is_on_axis(pair.plus_node))
      pair.normal[0] = 0.;
    if (pair.normal.norm() < 1e-3 * pair.area)
      throw InputError(
        fmt::format("A joint turns back on itself at {}; it has no normal there. Correct the {}.",
                    text_of(pair.position),
                    dim == 2 ? "line" : "surface"));
    pair.normal /= pair.normal.norm();
  }


  template <int dim>
  auto
  JointGeometry<dim>::find_or_add(const unsigned int joint,
                                  const Nodes &nodes,
                                  const unsigned int part,
                                  KnownPairs &known) -> KnownPair &
  {
    std::vector<KnownPair> &parts = known[nodes];
    Assert(part <= parts.size(), dealii::ExcInternalError());
    if (part == parts.size())
      {
        NodePair<dim> pair;
        pair.joint      = joint;
        pair.plus_node  = nodes.first;
        pair.minus_node = nodes.second;
        pair.part       = part;
        pair.position   = discretization.position(nodes.first);
        parts.push_back({static_cast<unsigned int>(all_pairs.size()), {}});
        all_pairs.push_back(pair);
      }
    return parts[part];
  }


  // With δ_h = Σ w_k δ_k, the work of a pressure on the jump of a hanging pair is work on its
  // masters: areas, and normals weighted by them, become integrals of the shape functions of the
  // constrained space.
  template <int dim>
  void
  JointGeometry<dim>::move_to_masters(const double corner_angle, KnownPairs &known)
  {
    std::map<unsigned int, KnownPair> hanging; // by number
    for (const auto &[nodes, parts] : known)
      if (discretization.hanging_nodes().contain(nodes.first) ||
          discretization.hanging_nodes().contain(nodes.second))
        for (const KnownPair &pair : parts)
          hanging[pair.index] = pair;
    for (const auto &[number, pair] : hanging)
      {
        find_masters(pair, corner_angle, known);
        for (const auto &[master, weight] : all_pairs[number].masters)
          {
            all_pairs[master].area += weight * all_pairs[number].area;
            all_pairs[master].normal += weight * all_pairs[number].normal;
          }
        all_pairs[number].area = 0.;
      }
  }


  // Lips are refined alike (mesh_refinement): a node hangs together with the one that it faces, and
  // their masters face each other. Masters that only a cell beside the joint has become a pair
  // here.
  template <int dim>
  void
  JointGeometry<dim>::find_masters(const KnownPair &hanging_pair,
                                   const double corner_angle,
                                   KnownPairs &known)
  {
    const NodePair<dim> pair = all_pairs[hanging_pair.index]; // a copy: pairs may be added
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
        const Nodes nodes(plus, minus);
        const unsigned int part = part_of_master(known[nodes], hanging_pair.normals, corner_angle);
        KnownPair &master       = find_or_add(pair.joint, nodes, part, known);
        if (master.normals.empty())
          master.normals = hanging_pair.normals;
        masters.emplace_back(master.index, weight);
      }
    all_pairs[hanging_pair.index].masters = std::move(masters);
  }


  template <int dim>
  unsigned int
  JointGeometry<dim>::part_of_master(const std::vector<KnownPair> &of_master,
                                     const std::vector<Normal> &normals,
                                     const double corner_angle) const
  {
    auto nearest     = static_cast<unsigned int>(of_master.size());
    double alignment = -2.;
    for (unsigned int part = 0; part < of_master.size(); ++part)
      for (const Normal &of_part : of_master[part].normals)
        for (const Normal &normal : normals)
          if (!is_corner(of_part, normal, corner_angle) && of_part * normal > alignment)
            {
              nearest   = part;
              alignment = of_part * normal;
            }
    return nearest;
  }


  template class JointGeometry<2>;
  template class JointGeometry<3>;
} // namespace fuga
