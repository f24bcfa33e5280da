// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/depth_pressure.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Heights that differ by less are the same, relative to the length of the face. */
    constexpr double height_tolerance = 1e-9;

    /** Heights of the first and the last corner of a face. */
    template <int dim>
    std::array<double, 2>
    heights(const Discretization<dim> &space,
            const typename Discretization<dim>::BoundaryFace &face)
    {
      const std::size_t last = space.reference_element().face(face.number).nodes.size() - 1;
      return {{space.position(space.face_node(face, 0))[1],
               space.position(space.face_node(face, last))[1]}};
    }

    /** The part of a face below the level, from its higher to its lower end. */
    struct WettedPart
    {
      /** Positions in units of the face, from its first corner. */
      double begin = 0., end = 1.;
      /** Square roots of the depths there. */
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
    for (const auto &face : space.boundary_faces())
      {
        if (face.label == JointedMesh::no_label || !loaded[face.label])
          continue;
        const double length   = space.face_length(face);
        const WettedPart part = wetted_part(heights(space, face), level);
        const double sum      = part.root_begin + part.root_end;
        if (part.root_end * part.root_end <= height_tolerance * length)
          continue;
        const std::size_t n = space.reference_element().face(face.number).nodes.size();
        const auto normal   = space.outer_normal(face);
        const auto first    = space.position(space.face_node(face, 0));
        const auto along    = space.position(space.face_node(face, n - 1)) - first;
        // With z = √d linear in the parameter τ, and degree p of the shape functions, the integrand
        // is a polynomial in τ of degree 2p + 3, and 2p + 5 with a radius as factor.
        const dealii::QGauss<1> rule(static_cast<unsigned int>(n) + 2);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double tau = rule.point(q)[0];
            const double z   = part.root_begin + tau * (part.root_end - part.root_begin);
            const double position =
              part.begin + (part.end - part.begin) * tau * (z + part.root_begin) / sum;
            const double p     = pressure.surcharge + pressure.gradient * z * z + root * z;
            const double force = rule.weight(q) * 2. * z / sum * std::abs(part.end - part.begin) *
                                 length * space.extent_across(first + position * along) * p;
            const auto values = space.reference_element().face_values(face.number, position);
            for (std::size_t k = 0; k < n; ++k)
              for (unsigned int c = 0; c < dim; ++c)
                forces[space.face_node(face, k) * dim + c] -= force * values[k] * normal[c];
          }
      }
  }


  template <int dim>
  std::vector<double>
  levels_of_kinks(const Discretization<dim> &space, const std::vector<bool> &loaded)
  {
    std::vector<double> flat, ends;
    for (const auto &face : space.boundary_faces())
      if (face.label != JointedMesh::no_label && loaded[face.label])
        {
          const auto y = heights(space, face);
          ends.insert(ends.end(), y.begin(), y.end());
          if (std::abs(y[1] - y[0]) <= height_tolerance * space.face_length(face))
            flat.push_back(y[0]);
        }
    if (ends.empty())
      return {};
    const auto [lowest, highest] = std::minmax_element(ends.begin(), ends.end());
    const double tolerance       = height_tolerance * (*highest - *lowest);
    flat.insert(flat.end(), {*lowest, *highest});
    std::sort(flat.begin(), flat.end());
    flat.erase(std::unique(flat.begin(),
                           flat.end(),
                           [&](const double a, const double b) { return b - a <= tolerance; }),
               flat.end());
    return flat;
  }


  template void
  add_depth_pressure(const Discretization<2> &,
                     const DepthPressure &,
                     const double,
                     const std::vector<bool> &,
                     Vector &);
  template std::vector<double>
  levels_of_kinks(const Discretization<2> &, const std::vector<bool> &);
} // namespace fuga
