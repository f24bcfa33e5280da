// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/output/results/joint_resultant.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    using Tensor = dealii::Tensor<1, 3>;

    Tensor
    tensor(const std::array<double, 3> &values)
    {
      Tensor result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = values[c];
      return result;
    }

    std::array<double, 3>
    array(const Tensor &values)
    {
      return {{values[0], values[1], values[2]}};
    }

    /** Centroid and axes of a joint. */
    struct MeanPlane
    {
      double area = 0.;
      Tensor center, n, t1, t2;
    };

    MeanPlane
    mean_frame(const std::vector<std::size_t> &members,
               const std::vector<ContactElement> &elements,
               const std::vector<ElementFrame> &frames)
    {
      MeanPlane frame;
      for (const std::size_t k : members)
        {
          frame.area += elements[k].area;
          frame.center += elements[k].area * tensor(elements[k].position);
          frame.n += elements[k].area * tensor(frames[k].normal);
        }
      frame.center /= frame.area;
      // A closed surface has no mean normal, so its resultant is given in global axes.
      if (frame.n.norm() <= 1e-9 * frame.area)
        {
          frame.n    = Tensor();
          frame.n[2] = 1.;
        }
      frame.n /= frame.n.norm();
      const auto t = tangents(frame.n);
      frame.t1     = t[0];
      frame.t2     = t[1];
      return frame;
    }

    JointResultant
    joint_resultant(const std::vector<std::size_t> &members,
                    const std::vector<ContactElement> &elements,
                    const std::vector<ElementFrame> &frames,
                    const std::vector<ElementResult> &results,
                    const Vector &dissipation)
    {
      const MeanPlane frame = mean_frame(members, elements, frames);
      JointResultant resultant;
      resultant.smallest_pressure = members.empty() ? 0. : infinity;
      double strength             = 0.;
      Tensor sum,
        moment; // the moment of the forces on the plus side, which are the negative bar forces
      for (const std::size_t k : members)
        {
          const ElementResult &result = results[k];
          const Tensor n              = tensor(frames[k].normal);
          const Tensor force          = result.N * n + result.T * tensor(frames[k].tangents[0]) +
                               result.T2 * tensor(frames[k].tangents[1]);
          sum += force;
          moment -= dealii::cross_product_3d(tensor(elements[k].position) - frame.center, force);
          resultant.water += result.water_pressure * elements[k].area * (n * frame.n);
          strength += result.strength;
          add_element(result, elements[k].area / frame.area, dissipation[k], resultant);
        }
      resultant.N             = sum * frame.n;
      resultant.T             = sum * frame.t1;
      resultant.T2            = sum * frame.t2;
      resultant.M             = -(moment * frame.t2);
      resultant.M1            = moment * frame.t1;
      resultant.Mn            = moment * frame.n;
      const bool is_loaded    = resultant.N != 0.;
      resultant.eccentricity  = is_loaded ? -resultant.M / resultant.N : not_a_number;
      resultant.eccentricity2 = is_loaded ? -resultant.M1 / resultant.N : not_a_number;
      resultant.position      = array(frame.center + resultant.eccentricity * frame.t1 +
                                 resultant.eccentricity2 * frame.t2);
      resultant.normal        = array(frame.n);
      resultant.first_tangent = array(frame.t1);
      const double shear      = std::hypot(resultant.T, resultant.T2);
      resultant.sliding_safety =
        shear <= resultant_rounding * std::max(strength, std::abs(resultant.N)) ? infinity
                                                                                : strength / shear;
      resultant.cracked_length = resultant.crack_from_first = resultant.crack_from_last =
        resultant.overturning_safety = resultant.in_middle_third = not_a_number;
      return resultant;
    }
  } // namespace

  std::vector<JointResultant>
  joint_resultants_in_space(const std::size_t n_joints,
                            const std::vector<ContactElement> &elements,
                            const std::vector<ElementFrame> &frames,
                            const std::vector<ElementResult> &results,
                            const Vector &dissipation)
  {
    std::vector<std::vector<std::size_t>> members(n_joints);
    for (std::size_t k = 0; k < elements.size(); ++k)
      members[elements[k].joint].push_back(k);
    std::vector<JointResultant> resultants;
    for (const auto &joint : members)
      resultants.push_back(joint_resultant(joint, elements, frames, results, dissipation));
    return resultants;
  }
} // namespace fuga
