// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/layer_response.h>
#include <fuga/io/joint_results.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  std::vector<ElementResult>
  element_results(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &jumps)
  {
    std::vector<ElementResult> results(elements.size());
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        ElementResult &result         = results[k];
        const double g = element.initial_gap + jumps[element.normal_bar] - state.dilations[k];
        result.state   = state.states[k];
        result.jump_n  = jumps[element.normal_bar];
        // Rounding must not give an open element a force, nor a closed one a gap.
        if (result.state == ContactState::open)
          result.gap = std::max(g, 0.);
        else
          {
            result.N       = std::min(state.forces[element.normal_bar], state.strengths[k].tension);
            result.closure = std::max(-g, 0.);
          }
        if (element.has_tangential_bar())
          {
            const double T = state.forces[element.tangential_bar];
            result.T =
              result.state == ContactState::open ? state.unreleased[element.tangential_bar] : T;
            result.jump_t = jumps[element.tangential_bar];
            result.slip   = state.slips[k];
          }
        result.pressure = result.N == 0. ? 0. : -result.N / element.area;
        result.shear    = result.T / element.area;
        if (result.state != ContactState::open)
          result.strength = shear_strength(element, state, k);
        if (is_slipping(result.state))
          result.utilisation = 1.;
        else if (result.state == ContactState::stick && result.strength > 0.)
          result.utilisation = std::min(1., std::abs(result.T) / result.strength);
      }
    return results;
  }

  namespace
  {
    /** Area-weighted centroid and mean unit normal of a joint. */
    struct MeanFrame
    {
      double area = 0.;
      double x = 0., y = 0., n_x = 0., n_y = 0.;
    };

    MeanFrame
    mean_frame(const unsigned int joint,
               const std::vector<ContactElement> &elements,
               const std::vector<std::array<double, 3>> &normals)
    {
      MeanFrame frame;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (elements[k].joint == joint)
          {
            const double A = elements[k].area;
            frame.area += A;
            frame.x += A * elements[k].position[0];
            frame.y += A * elements[k].position[1];
            frame.n_x += A * normals[k][0];
            frame.n_y += A * normals[k][1];
          }
      frame.x /= frame.area;
      frame.y /= frame.area;
      const double length = std::hypot(frame.n_x, frame.n_y);
      // A closed ring has no mean normal: its resultant is given in global axes.
      const double shortest = 1e-9;
      frame.n_y             = length > shortest * frame.area ? frame.n_y / length : 1.;
      frame.n_x             = length > shortest * frame.area ? frame.n_x / length : 0.;
      return frame;
    }
  } // namespace

  JointResultant
  joint_resultant(const unsigned int joint,
                  const std::vector<ContactElement> &elements,
                  const std::vector<std::array<double, 3>> &normals,
                  const std::vector<ElementResult> &results)
  {
    const MeanFrame frame = mean_frame(joint, elements, normals);
    JointResultant resultant;
    double sum_N = 0., moment_N = 0., strength = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const ElementResult &result   = results[k];
        if (element.joint != joint)
          continue;
        const double n_x = normals[k][0], n_y = normals[k][1], t_x = n_y, t_y = -n_x;
        const double F_x = result.N * n_x + result.T * t_x, F_y = result.N * n_y + result.T * t_y;
        const double x = element.position[0] - frame.x, y = element.position[1] - frame.y;
        resultant.N += F_x * frame.n_x + F_y * frame.n_y;
        resultant.T += F_x * frame.n_y - F_y * frame.n_x;
        resultant.M -= x * F_y - y * F_x;
        sum_N += result.N;
        moment_N += result.N * (x * frame.n_y - y * frame.n_x);
        double &share = result.state == ContactState::open    ? resultant.share_open
                        : result.state == ContactState::stick ? resultant.share_stick
                                                              : resultant.share_slip;
        share += element.area / frame.area;
        strength += result.strength;
        resultant.largest_pressure = std::max(resultant.largest_pressure, result.pressure);
        resultant.largest_gap      = std::max(resultant.largest_gap, result.gap);
        resultant.largest_slip     = std::max(resultant.largest_slip, std::abs(result.slip));
      }
    const double arm   = sum_N == 0. ? 0. : moment_N / sum_N;
    resultant.position = {{frame.x + arm * frame.n_y, frame.y - arm * frame.n_x}};
    // A shear that is only rounding is none.
    const double rounding    = 1e-12;
    resultant.sliding_safety = std::abs(resultant.T) <= rounding * strength
                                 ? std::numeric_limits<double>::infinity()
                                 : strength / std::abs(resultant.T);
    return resultant;
  }
} // namespace fuga
