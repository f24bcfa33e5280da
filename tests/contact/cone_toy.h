// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_cone_toy_h
#define fuga_tests_contact_cone_toy_h

#include "contact/toy_system.h"

#include <fuga/contact/path/event_path.h>

#include <gtest/gtest.h>
#include <random>

namespace fuga::tests
{
  /** Elements with three bars each (rows 3k, 3k+1, 3k+2) and equal laws, kept together with them.
   */
  struct ConeJoint
  {
    std::unique_ptr<ComplianceLaw> normal, shear;
    std::vector<ContactElement> elements;

    ConeJoint(const std::size_t n,
              const double area,
              std::unique_ptr<ComplianceLaw> normal_law,
              std::unique_ptr<ComplianceLaw> shear_law,
              const double friction);
  };

  /** A path and all that it reported. */
  struct ConeRun
  {
    PathResult result;
    Record record;
    IterationCount iterations;

    ConeRun(const ContactSystem &system,
            const std::vector<ContactElement> &elements,
            const LoadHistory &history,
            const std::vector<double> &levels)
      : record(system, elements, history)
    {
      const LayeredSystem layered(system, elements);
      EventPath path(elements, layered, history, PathOptions());
      result     = path.run(levels, record);
      iterations = path.iterations();
    }
  };

  /** The same elements at the same loads, but for rounding. */
  void
  expect_same_events(const std::vector<ContactEvent> &a, const std::vector<ContactEvent> &b);

  /** A random symmetric positive definite matrix with a diagonal of the order of one. */
  DenseMatrix
  random_stiffness(const std::size_t n, std::mt19937 &generator);

  /** Random forces on the jumps: pattern 0 presses, the others are arbitrary. */
  DenseMatrix
  random_loads(const std::size_t n_elements, std::mt19937 &generator);

  /** Elastic bodies with both for elements with three bars. */
  ToySystem
  random_bodies(const std::size_t n_elements, std::mt19937 &generator);

  /** Pressing, then round about with reversals. */
  LoadHistory
  roundabout();

  double
  largest_difference(const Vector &a, const Vector &b);

  /**
   * The contact problem at given loads after a step from given slips, by Gauss-Seidel sweeps from
   * element to element: backward Euler's return mapping. `tangential_base` are the slips before the
   * step (two per element); W and the forces without dislocations are given. Returns the
   * dislocations.
   */
  Vector
  return_mapping(const DenseMatrix &W,
                 const Vector &reactions,
                 const Vector &initial_gaps,
                 const double friction,
                 const Vector &before,
                 const double tolerance);
} // namespace fuga::tests

#endif
