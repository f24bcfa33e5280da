// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_cut_polyhedron_points_h
#define fuga_tests_stress_cut_polyhedron_points_h

#include "stress/cut_polyhedron.h"

#include <cmath>

namespace fuga::stress
{
  inline CutPolyhedron::Point
  sum(const CutPolyhedron::Point &a, const double factor, const CutPolyhedron::Point &b)
  {
    return {{a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]}};
  }

  inline double
  dot(const CutPolyhedron::Point &a, const CutPolyhedron::Point &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  inline CutPolyhedron::Point
  cross(const CutPolyhedron::Point &a, const CutPolyhedron::Point &b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }

  inline double
  length(const CutPolyhedron::Point &a)
  {
    return std::sqrt(dot(a, a));
  }
} // namespace fuga::stress

#endif
