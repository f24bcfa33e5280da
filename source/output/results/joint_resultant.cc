// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/results/joint_resultant.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Centroid, mean normal and edges of a joint. */
    struct MeanFrame
    {
      double area = 0.;
      double x = 0., y = 0., n_x = 0., n_y = 0.;
      double first_edge = infinity, last_edge = -infinity;

      double
      along(const std::array<double, 3> &position) const
      {
        return (position[0] - x) * n_y - (position[1] - y) * n_x;
      }
    };

    /** Return the length that an element stands for; @p members are in the order along the
     * joint. */
    double
    length_of(const std::size_t number,
              const std::vector<std::size_t> &members,
              const std::vector<ContactElement> &elements,
              const AcrossPlane &across_plane)
    {
      if (!across_plane.axisymmetric)
        return elements[members[number]].area / across_plane.thickness;
      const auto distance = [&](const std::size_t a, const std::size_t b) {
        const auto &p = elements[members[a]].position, &q = elements[members[b]].position;
        return std::hypot(p[0] - q[0], p[1] - q[1]);
      };
      return (number > 0 ? distance(number - 1, number) / 2. : 0.) +
             (number + 1 < members.size() ? distance(number, number + 1) / 2. : 0.);
    }

    /** Return the mean frame. The mean normal is that of the chord: rings of a joint around an axis
     * count by their lengths, so that the vertical sides of a key do not turn it. */
    MeanFrame
    mean_frame(const std::vector<std::size_t> &members,
               const std::vector<ContactElement> &elements,
               const std::vector<std::array<double, 3>> &normals,
               const AcrossPlane &across_plane)
    {
      MeanFrame frame;
      double whole_length = 0.;
      for (std::size_t i = 0; i < members.size(); ++i)
        {
          const std::size_t k = members[i];
          const double A      = elements[k].area;
          // A single ring has no neighbour that determines its length, and needs none.
          const double L = members.size() > 1 ? length_of(i, members, elements, across_plane) : 1.;
          frame.area += A;
          frame.x += A * elements[k].position[0];
          frame.y += A * elements[k].position[1];
          whole_length += L;
          frame.n_x += L * normals[k][0];
          frame.n_y += L * normals[k][1];
        }
      frame.x /= frame.area;
      frame.y /= frame.area;
      const double length = std::hypot(frame.n_x, frame.n_y);
      // A closed ring has no mean normal, so its resultant is given in global axes.
      const double shortest = 1e-9;
      frame.n_y             = length > shortest * whole_length ? frame.n_y / length : 1.;
      frame.n_x             = length > shortest * whole_length ? frame.n_x / length : 0.;
      for (const std::size_t k : members)
        {
          const double s   = frame.along(elements[k].position);
          frame.first_edge = std::min(frame.first_edge, s);
          frame.last_edge  = std::max(frame.last_edge, s);
        }
      return frame;
    }

    /** Measure the lengths of the open parts; @p members are in the order along the joint. */
    void
    measure_cracks(const std::vector<std::size_t> &members,
                   const std::vector<ContactElement> &elements,
                   const std::vector<ElementResult> &results,
                   const AcrossPlane &across_plane,
                   JointResultant &resultant)
    {
      const std::size_t n = members.size();
      const auto is_open  = [&](const std::size_t i) {
        return results[members[i]].state == ContactState::open;
      };
      const auto length = [&](const std::size_t i) {
        return length_of(i, members, elements, across_plane);
      };
      for (std::size_t i = 0; i < n; ++i)
        resultant.cracked_length += is_open(i) ? length(i) : 0.;
      for (std::size_t i = 0; i < n && is_open(i); ++i)
        resultant.crack_from_first += length(i);
      for (std::size_t i = n; i > 0 && is_open(i - 1); --i)
        resultant.crack_from_last += length(i - 1);
    }

    /** Compute the position of the resultant from N and M. */
    void
    locate(const MeanFrame &frame, JointResultant &resultant)
    {
      const double e               = resultant.N == 0. ? not_a_number : -resultant.M / resultant.N;
      const double B               = frame.last_edge - frame.first_edge;
      resultant.eccentricity       = e;
      resultant.position           = {{frame.x + e * frame.n_y, frame.y - e * frame.n_x, 0.}};
      resultant.in_middle_third    = e >= frame.first_edge + B * (1. / 3. - resultant_rounding) &&
                                      e <= frame.last_edge - B * (1. / 3. - resultant_rounding)
                                       ? 1.
                                       : 0.;
      resultant.overturning_safety = std::abs(e) <= resultant_rounding * B ? infinity
                                     : e > 0.                              ? frame.last_edge / e
                                                                           : frame.first_edge / e;
    }

    JointResultant
    joint_resultant(const std::vector<std::size_t> &members,
                    const std::vector<ContactElement> &elements,
                    const std::vector<std::array<double, 3>> &normals,
                    const std::vector<ElementResult> &results,
                    const Vector &dissipation,
                    const AcrossPlane &across_plane)
    {
      const MeanFrame frame = mean_frame(members, elements, normals, across_plane);
      JointResultant resultant;
      resultant.smallest_pressure = members.empty() ? 0. : infinity;
      double strength             = 0.;
      for (const std::size_t k : members)
        {
          const ContactElement &element = elements[k];
          const ElementResult &result   = results[k];
          const double n_x = normals[k][0], n_y = normals[k][1], t_x = n_y, t_y = -n_x;
          const double F_x = result.N * n_x + result.T * t_x;
          const double F_y = result.N * n_y + result.T * t_y;
          resultant.N += F_x * frame.n_x + F_y * frame.n_y;
          resultant.T += F_x * frame.n_y - F_y * frame.n_x;
          resultant.M -=
            (element.position[0] - frame.x) * F_y - (element.position[1] - frame.y) * F_x;
          resultant.water +=
            result.water_pressure * element.area * (n_x * frame.n_x + n_y * frame.n_y);
          strength += result.strength;
          add_element(result, element.area / frame.area, dissipation[k], resultant);
        }
      measure_cracks(members, elements, results, across_plane, resultant);
      if (across_plane.axisymmetric)
        resultant.M = not_a_number;
      locate(frame, resultant);
      resultant.sliding_safety = std::abs(resultant.T) <= resultant_rounding * strength
                                   ? infinity
                                   : strength / std::abs(resultant.T);
      return resultant;
    }
  } // namespace

  void
  add_element(const ElementResult &result,
              const double share,
              const double dissipation,
              JointResultant &resultant)
  {
    (result.state == ContactState::open    ? resultant.share_open
     : result.state == ContactState::stick ? resultant.share_stick
                                           : resultant.share_slip) += share;
    resultant.share_compression += result.pressure > 0. ? share : 0.;
    resultant.dissipation += dissipation;
    resultant.largest_pressure  = std::max(resultant.largest_pressure, result.pressure);
    resultant.smallest_pressure = std::min(resultant.smallest_pressure, result.pressure);
    resultant.largest_gap       = std::max(resultant.largest_gap, result.gap);
    resultant.largest_slip =
      std::max(resultant.largest_slip, std::hypot(result.slip, result.slip2));
    resultant.mean_slip += share * result.slip;
    resultant.mean_slip2 += share * result.slip2;
  }

  std::vector<JointResultant>
  joint_resultants(const std::size_t n_joints,
                   const std::vector<ContactElement> &elements,
                   const std::vector<std::array<double, 3>> &normals,
                   const std::vector<ElementResult> &results,
                   const Vector &dissipation,
                   const AcrossPlane &across_plane)
  {
    std::vector<std::vector<std::size_t>> members(n_joints);
    for (std::size_t k = 0; k < elements.size(); ++k)
      members[elements[k].joint].push_back(k);
    std::vector<JointResultant> resultants;
    for (const auto &joint : members)
      resultants.push_back(
        joint_resultant(joint, elements, normals, results, dissipation, across_plane));
    return resultants;
  }
} // namespace fuga
