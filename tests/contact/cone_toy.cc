// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <cmath>

namespace fuga::tests
{
  ConeJoint::ConeJoint(const std::size_t n,
                       const double area,
                       std::unique_ptr<ComplianceLaw> normal_law,
                       std::unique_ptr<ComplianceLaw> shear_law,
                       const double friction)
    : normal(std::move(normal_law)), shear(std::move(shear_law)), elements(n)
  {
    for (std::size_t k = 0; k < n; ++k)
      {
        ContactElement &element       = elements[k];
        element.normal_bar            = static_cast<unsigned int>(3 * k);
        element.tangential_bar        = static_cast<unsigned int>(3 * k + 1);
        element.second_tangential_bar = static_cast<unsigned int>(3 * k + 2);
        element.number                = static_cast<unsigned int>(k);
        element.area                  = area;
        element.normal_law            = normal.get();
        element.shear_law             = shear.get();
        element.friction.coefficient  = friction;
      }
  }

  void
  expect_same_events(const std::vector<ContactEvent> &a, const std::vector<ContactEvent> &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        EXPECT_NEAR(a[i].t, b[i].t, 1e-9) << "event " << i;
        EXPECT_EQ(a[i].element, b[i].element) << "event " << i;
        EXPECT_EQ(state_name(a[i].to), state_name(b[i].to)) << "event " << i;
      }
  }

  DenseMatrix
  random_stiffness(const std::size_t n, std::mt19937 &generator)
  {
    std::normal_distribution<double> normal;
    DenseMatrix A(n, n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        A(i, j) = normal(generator);
    DenseMatrix S = multiply_transposed(A, A);
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < n; ++i)
          S(i, j) *= 0.7 / static_cast<double>(n);
        S(j, j) += 0.5;
      }
    return S;
  }

  DenseMatrix
  random_loads(const std::size_t n_elements, std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    DenseMatrix F(3 * n_elements, 3);
    for (std::size_t k = 0; k < n_elements; ++k)
      {
        F(3 * k, 0) = -1. - 0.3 * uniform(generator);
        for (std::size_t j = 1; j < 3; ++j)
          for (std::size_t i = 0; i < 3; ++i)
            F(3 * k + i, j) = uniform(generator) * (i == 0 ? 0.6 : 1.);
      }
    return F;
  }

  LoadHistory
  roundabout()
  {
    return LoadHistory({0., 1., 2., 3., 4., 5.},
                       {{0., 0., 0.},
                        {1., 0., 0.},
                        {1., 1.2, 0.},
                        {0.9, 0.6, 1.3},
                        {1.1, -1., 0.4},
                        {1., 0.2, -1.2}});
  }

  double
  largest_difference(const Vector &a, const Vector &b)
  {
    double result = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      result = std::max(result, std::abs(a[i] - b[i]));
    return result;
  }

  ToySystem
  random_bodies(const std::size_t n_elements, std::mt19937 &generator)
  {
    ToySystem system;
    system.S = random_stiffness(3 * n_elements, generator);
    system.F = random_loads(n_elements, generator);
    return system;
  }

  // The update of one element with its own stiffness taken for a scalar (the trace of its block):
  // the projection of Alart and Curnier, a contraction for moderate friction.
  Vector
  return_mapping(const DenseMatrix &W,
                 const Vector &reactions,
                 const Vector &initial_gaps,
                 const double friction,
                 const Vector &before,
                 const double tolerance)
  {
    Vector d = before;
    Vector p = reactions;
    for (std::size_t j = 0; j < d.size(); ++j)
      for (std::size_t i = 0; i < d.size(); ++i)
        p[i] -= W(i, j) * d[j];
    const auto move = [&](const std::size_t bar, const double change) {
      d[bar] += change;
      for (std::size_t i = 0; i < d.size(); ++i)
        p[i] -= W(i, bar) * change;
    };
    for (int sweep = 0; sweep < 100000; ++sweep)
      {
        double largest = 0.;
        for (std::size_t k = 0; k < initial_gaps.size(); ++k)
          {
            const std::size_t n = 3 * k, t = 3 * k + 1;
            // Normal: lips closed (d = -g0) or without force.
            const double opening = std::max(d[n] + p[n] / W(n, n), -initial_gaps[k]) - d[n];
            move(n, opening);
            const double strength  = friction * std::max(-p[n], 0.);
            const double stiffness = 1.5 * std::max(W(t, t), W(t + 1, t + 1));
            // Trial force if the slip of the step were undone.
            const double x0 = d[t] - before[t], x1 = d[t + 1] - before[t + 1];
            const double q0 = p[t] + stiffness * x0, q1 = p[t + 1] + stiffness * x1;
            const double size  = std::hypot(q0, q1);
            const double share = size > strength ? 1. - strength / size : 0.;
            const double c0 = share * q0 / stiffness - x0, c1 = share * q1 / stiffness - x1;
            move(t, c0);
            move(t + 1, c1);
            largest = std::max({largest, std::abs(opening), std::abs(c0), std::abs(c1)});
          }
        if (largest < tolerance)
          return d;
      }
    ADD_FAILURE() << "Gauss-Seidel did not converge.";
    return d;
  }
} // namespace fuga::tests
