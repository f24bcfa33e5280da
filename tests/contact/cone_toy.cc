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

  ConeRun::ConeRun(const ContactSystem &system,
                   const std::vector<ContactElement> &elements,
                   const LoadHistory &history,
                   const std::vector<double> &levels)
    : record(system, elements, history)
  {
    const LayeredSystem layered(system, elements);
    ConePath path(elements, layered, history, PathOptions());
    result     = path.run(levels, record);
    iterations = path.iterations();
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
