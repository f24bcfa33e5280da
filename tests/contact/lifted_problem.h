// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_lifted_problem_h
#define fuga_tests_contact_lifted_problem_h

#include "contact/toy_system.h"

#include <functional>

namespace fuga::tests
{
  /**
   * A plane problem put into space: the elements get a second tangent, in whose direction elastic
   * bodies of their own are not loaded, and the frame of both tangents of element k is turned about
   * the normal by an angle of its own, k + 1/2. The coordinates x of the bodies stay those of the
   * plane, with one more per element.
   */
  struct LiftedProblem
  {
    ToySystem system;
    std::vector<ContactElement> elements;

    LiftedProblem(const ToySystem &plane, const std::vector<ContactElement> &plane_elements);

    /** Direction of the plane's tangent in the turned frame of element k. */
    static TangentVector
    tangent(const std::size_t k);

    /** Of a plane vector of the bars, with nothing in the direction of the second tangent. */
    static Vector
    lift(const Vector &of_plane_bars);

    static JointState
    lift(const JointState &state);

    static PathPoint
    lift(const PathPoint &point);
  };
} // namespace fuga::tests

#endif
