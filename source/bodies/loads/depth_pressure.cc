// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Heights that differ by less than this, relative to the length of the face, are the same. */
    constexpr double height_tolerance = 1e-9;

    /** The part of a face below the level, from its higher to its lower end. */
    struct WettedPart
    {
      /** Positions in units of the face, from its first corner. */
      double begin = 0., end = 1.;
      /** Square roots of the depths at these positions. */
      double root_begin = 0., root_end = 0.;
    };

    WettedPart
    wetted_part(const std::array<double, 2> &y, const double level)
    {
      double begin = 0., end = 1., d0 = level - y[0], d1 = level - y[1];
      if (d0 > d1)
        {
          std::swap(d0, d1);
          std::swap(begin, end);
        }
      if (d0 < 0. && d1 > 0.)
        {
          begin = begin + (end - begin) * (-d0 / (d1 - d0));
          d0    = 0.;
        }
      return {begin, end, std::sqrt(std::max(d0, 0.)), std::sqrt(std::max(d1, 0.))};
    }
  } // namespace


  template <int dim>
  void
  add_depth_pressure(const Discretization<dim> &space,
                     const DepthPressure &pressure,
                     const double level,
                     const std::vector<bool> &loaded,
                     Vector &forces)
  {
    const double root =
      pressure.root * std::sqrt(std::max(level - pressure.bottom, 0.)); // r √H, times √d
    for (const auto &face : space.boundary_faces(loaded))
      {
        const FaceMap<dim> map(space, face);
        const double length = space.face_length(face);
        const Vector y      = map.heights();
        Vector depths;
        for (const double height : y)
          depths.push_back(level - height);
        // With z = √d linear in the parameter τ, and degree p of the shape functions, the integrand
        // is a polynomial in τ of degree 2p + 3; its degree is 2p + 5 if a radius (or, for a face
        // that is not a parallelogram, the density of its area) is a factor.
        const unsigned int n_points = space.reference_element().scalar_element().degree + 3;
        const dealii::QGauss<1> rule(n_points);
        for (const auto &line : map.lines({depths}, n_points))
          {
            const WettedPart part =
              wetted_part({{map.interpolate(y, line.begin), map.interpolate(y, line.end)}}, level);
            const double sum = part.root_begin + part.root_end;
            if (part.root_end * part.root_end <= height_tolerance * length)
              continue;
            for (unsigned int q = 0; q < rule.size(); ++q)
              {
                const double tau = rule.point(q)[0];
                const double z   = part.root_begin + tau * (part.root_end - part.root_begin);
                const auto at =
                  line.at(part.begin + (part.end - part.begin) * tau * (z + part.root_begin) / sum);
                const double p     = pressure.surcharge + pressure.gradient * z * z + root * z;
                const double force = rule.weight(q) * 2. * z / sum *
                                     std::abs(part.end - part.begin) * line.weight *
                                     map.density(at) * p;
                const auto values = map.values(at);
                const auto normal = map.normal(at);
                for (std::size_t k = 0; k < values.size(); ++k)
                  for (unsigned int c = 0; c < dim; ++c)
                    forces[space.face_node(face, k) * dim + c] -= force * values[k] * normal[c];
              }
          }
      }
  }


  template <int dim>
  std::vector<double>
  levels_of_kinks(const Discretization<dim> &space,
                  const std::vector<typename Discretization<dim>::BoundaryFace> &faces,
                  std::vector<double> others)
  {
    if (faces.empty())
      return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double lowest = infinity, highest = -infinity;
    for (const auto &face : faces)
      {
        const Vector y           = FaceMap<dim>(space, face).heights();
        const auto [least, most] = std::minmax_element(y.begin(), y.end());
        if (*most - *least <= height_tolerance * space.face_length(face))
          others.push_back(*least);
        lowest  = std::min(lowest, *least);
        highest = std::max(highest, *most);
      }
    others.insert(others.end(), {lowest, highest});
    std::sort(others.begin(), others.end());
    const auto are_alike = [&](const double a, const double b) {
      return b - a <= std::max(height_tolerance * (highest - lowest), 1e-12 * std::abs(b));
    };
    others.erase(std::unique(others.begin(), others.end(), are_alike), others.end());
    return others;
  }


  template void
  add_depth_pressure(const Discretization<2> &,
                     const DepthPressure &,
                     const double,
                     const std::vector<bool> &,
                     Vector &);
  template std::vector<double>
  levels_of_kinks(const Discretization<2> &,
                  const std::vector<Discretization<2>::BoundaryFace> &,
                  std::vector<double>);
  template void
  add_depth_pressure(const Discretization<3> &,
                     const DepthPressure &,
                     const double,
                     const std::vector<bool> &,
                     Vector &);
  template std::vector<double>
  levels_of_kinks(const Discretization<3> &,
                  const std::vector<Discretization<3>::BoundaryFace> &,
                  std::vector<double>);
} // namespace fuga
