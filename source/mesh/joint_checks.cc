// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The checks of the definition of a joint: the part of JointResolver that opens nothing.

#include <fuga/base/similar_names.h>
#include <fuga/mesh/cell_geometry.h>
#include <fuga/mesh/joint_resolver.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace fuga
{
  namespace
  {
    /** Relative tolerance of lengths: two lips are drawn separately but from the same numbers. */
    constexpr double length_tolerance = 1e-9;
  } // namespace


  void
  JointResolver::check_names_differ() const
  {
    std::set<std::string> names;
    for (const JointDefinition &joint : joints)
      if (!joint.name.empty() && !names.insert(joint.name).second)
        fail(joint, "there are two joints of this name; names must differ; rename one");
  }


  void
  JointResolver::check_definition(const JointDefinition &joint) const
  {
    if (joint.name.empty())
      fail(joint, "a joint has no name; a name is needed for the output; give it one");
    const bool has_lips = !joint.plus_lip.empty() || !joint.minus_lip.empty();
    if (joint.line.empty() == !has_lips)
      fail(
        joint,
        fmt::format(
          "it states {}; needed is either a line inside the mesh or the lips of an open mesh; {}",
          has_lips ? "both a line and lips" : "neither a line nor lips",
          has_lips ? "remove one" : "state the line (or the plus lip and the minus lip)"));
    if (!joint.line.empty() && joint.against_rigid)
      fail(joint,
           "a line inside the mesh cannot be against a rigid obstacle; state the boundary that "
           "touches the obstacle "
           "as plus lip, without line");
    if (!joint.line.empty() && (joint.plus_body.empty() || joint.minus_body.empty()))
      fail(joint,
           "it states a line but not both bodies; needed are the bodies on the plus and minus side "
           "(the normal points "
           "from minus to plus; for a crack twice the same body)");
    if (joint.line.empty() && joint.plus_lip.empty())
      fail(joint,
           "it has no plus lip; the plus lip is the boundary the normal points into; state it");
    if (joint.line.empty() && joint.minus_lip.empty() != joint.against_rigid)
      fail(
        joint,
        joint.against_rigid
          ? "it has a minus lip although it is against a rigid obstacle; allowed is one of both; "
            "remove one"
          : "it has no minus lip; state the boundary on the minus side, or that the joint is "
            "against a rigid "
            "obstacle");
    check_body(joint, joint.plus_body);
    check_body(joint, joint.minus_body);
  }


  void
  JointResolver::check_body(const JointDefinition &joint, const std::string &body) const
  {
    const auto &names = open_mesh.body_names;
    if (!body.empty() && std::find(names.begin(), names.end(), body) == names.end())
      fail(joint,
           fmt::format("there is no body '{}' in {}; the bodies there are '{}'; correct the name{}",
                       body,
                       mesh.file_name,
                       fmt::join(names, "', '"),
                       did_you_mean(body, names, ". ")));
  }


  /** Inside one body only the drawing defines which side is plus, so it must not turn round on the
   * way. */
  void
  JointResolver::check_direction(const JointDefinition &joint, const Group &line) const
  {
    // ends of a line, or edges of a surface, with how often they are left and how often reached
    std::map<std::pair<unsigned int, unsigned int>, std::array<unsigned int, 2>> ends;
    const unsigned int n = n_vertices(face_shape(open_mesh.cells.front().shape));
    for (const auto &face : line.drawn)
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int a = face[i];
          const unsigned int b = n == 2 ? a : face[(i + 1) % n];
          ++ends[{std::min(a, b), std::max(a, b)}][n == 2 ? i : (a < b ? 0 : 1)];
        }
    for (const auto &[end, times] : ends)
      if (times[0] + times[1] == 2 && times[0] != 1)
        fail(
          joint,
          fmt::format(
            "the pieces of its line '{}' are drawn in different directions and meet at {}; inside "
            "one body "
            "the direction tells the plus side (left), so it must not change; reverse a piece with "
            "a "
            "minus sign in the Physical list",
            line.name,
            print_point(mesh.vertices[end.first], mesh.dimension)));
  }


  double
  JointResolver::measure(const std::string &group_name) const
  {
    double sum = 0;
    for (const Group &g : groups)
      if (g.name == group_name)
        for (const unsigned int half_face : g.half_faces)
          sum += face_measure(
            face_shape(open_mesh.cells.front().shape), vertices_of(half_face), mesh.vertices);
    return sum;
  }


  void
  JointResolver::check_lengths(const JointDefinition &joint) const
  {
    const double plus  = measure(joint.plus_lip);
    const double minus = measure(joint.minus_lip);
    if (std::abs(plus - minus) > length_tolerance * std::max(plus, minus))
      fail(joint,
           fmt::format(
             "its lips do not match: '{}' has the {} {:.15g}, '{}' has {:.15g}; they must agree to "
             "{:g}; "
             "limit both groups to the part where the bodies touch",
             joint.plus_lip,
             mesh.dimension == 2 ? "length" : "area",
             plus,
             joint.minus_lip,
             minus,
             length_tolerance));
  }
} // namespace fuga
