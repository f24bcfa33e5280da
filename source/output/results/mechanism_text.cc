// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/results/mechanism_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Share below which a motion is not mentioned. */
    constexpr double smallest_share = 1e-3;

    /** Sizes of the motion of one joint. In the plane they also include the rigid motion v + w e_z
     * x r of the plus face against the minus face that fits best, computed by sums over the
     * elements weighted with the area. */
    class Motion
    {
    public:
      void
      add(const ContactElement &element, const ElementFrame &frame, const Vector &jumps)
      {
        const auto jump = [&jumps](const unsigned int bar) {
          return bar == ContactElement::no_bar ? 0. : jumps[bar];
        };
        const double n = jump(element.normal_bar), t1 = jump(element.tangential_bar),
                     t2 = jump(element.second_tangential_bar);
        opening         = std::max(opening, std::abs(n));
        smallest_normal = std::min(smallest_normal, n);
        largest_normal  = std::max(largest_normal, n);
        sliding         = std::max(sliding, std::hypot(t1, t2));
        is_known        = is_known && element.has_tangential_bar();
        const double A = element.area, x = element.position[0], y = element.position[1],
                     u = n * frame.normal[0] + t1 * frame.tangents[0][0],
                     v = n * frame.normal[1] + t1 * frame.tangents[0][1];
        area += A;
        sum_x += A * x;
        sum_y += A * y;
        sum_u += A * u;
        sum_v += A * v;
        sum_rr += A * (x * x + y * y);
        sum_uu += A * (u * u + v * v);
        sum_ru += A * (x * v - y * u);
      }

      JointMotion
      result(const double largest, const bool in_space) const
      {
        JointMotion motion;
        if (std::max(opening, sliding) <= smallest_share * largest)
          return motion;
        const bool is_normal = opening > smallest_share * sliding;
        motion.closes        = is_normal && largest_normal <= smallest_share * opening;
        motion.opens         = is_normal && !motion.closes;
        motion.slides        = sliding > smallest_share * opening;
        motion.turns = is_normal && largest_normal - smallest_normal > smallest_share * opening;
        if (motion.turns && is_known && !in_space)
          motion.centre = centre();
        return motion;
      }

    private:
      std::optional<std::array<double, 2>>
      centre() const
      {
        const double x = sum_x / area, y = sum_y / area, u = sum_u / area, v = sum_v / area;
        const double inertia = sum_rr / area - x * x - y * y;
        const double w       = (sum_ru / area - x * v + y * u) / inertia;
        const double misfit  = sum_uu / area - u * u - v * v - w * w * inertia;
        if (!(misfit <= std::pow(smallest_share * opening, 2)))
          return {};
        const auto rounded = [inertia](const double value) {
          return std::abs(value) < 1e-6 * std::sqrt(inertia) ? 0. : value;
        };
        return std::array<double, 2>{{rounded(x - v / w), rounded(y + u / w)}};
      }

      double opening = 0., sliding = 0.;
      double smallest_normal = std::numeric_limits<double>::infinity();
      double largest_normal  = -std::numeric_limits<double>::infinity();
      bool is_known          = true;
      double area = 0., sum_x = 0., sum_y = 0., sum_u = 0., sum_v = 0.;
      double sum_rr = 0., sum_uu = 0., sum_ru = 0.;
    };
  } // namespace

  std::vector<JointMotion>
  joint_motions(const std::size_t n_joints,
                const std::vector<ContactElement> &elements,
                const std::vector<ElementFrame> &frames,
                const Vector &jumps,
                const bool in_space)
  {
    std::vector<Motion> motions(n_joints);
    for (std::size_t k = 0; k < elements.size(); ++k)
      motions[elements[k].joint].add(elements[k], frames[k], jumps);
    double largest = 0.;
    for (const double jump : jumps)
      largest = std::max(largest, std::abs(jump));
    std::vector<JointMotion> result;
    for (const Motion &motion : motions)
      result.push_back(motion.result(largest, in_space));
    return result;
  }

  std::string
  mechanism_text(const std::vector<JointMotion> &motions,
                 const std::vector<std::string> &joint_names)
  {
    std::string sliding, rest;
    for (std::size_t j = 0; j < motions.size(); ++j)
      {
        const JointMotion &motion = motions[j];
        const bool is_normal      = motion.opens || motion.closes;
        if (motion.slides && !is_normal)
          sliding += fmt::format("{}'{}'", sliding.empty() ? "slides on " : ", ", joint_names[j]);
        else if (is_normal)
          {
            rest += fmt::format("{}'{}' {}{}",
                                rest.empty() ? "" : "; ",
                                joint_names[j],
                                motion.closes ? "closes" : "opens",
                                motion.slides ? " and slides" : "");
            if (motion.turns)
              rest += motion.centre ? fmt::format(", turning about ({:.4g}, {:.4g})",
                                                  (*motion.centre)[0],
                                                  (*motion.centre)[1])
                                    : std::string(", turning");
          }
      }
    return sliding + (sliding.empty() || rest.empty() ? "" : "; ") + rest;
  }
} // namespace fuga
