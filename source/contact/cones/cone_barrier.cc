// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_barrier.h>
#include <fuga/contact/cones/cone_program.h>

#include <array>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Remove from the columns of @p A, and from @p b, the part that lies along the columns of
     * @p free. */
    void
    project_out(DenseMatrix free, DenseMatrix &A, Vector &b)
    {
      constexpr double dependent = 1e-10;
      for (Eigen::Index j = 0; j < free.cols(); ++j)
        {
          auto unit          = free.col(j);
          const double whole = unit.norm();
          for (int twice = 0; twice < 2; ++twice)
            for (Eigen::Index k = 0; k < j; ++k)
              unit -= free.col(k).dot(unit) * free.col(k);
          const double left = unit.norm();
          unit *= left > dependent * whole ? 1. / left : 0.;
          for (int twice = 0; twice < 2; ++twice)
            {
              for (Eigen::Index k = 0; k < A.cols(); ++k)
                A.col(k) -= unit.dot(A.col(k)) * unit;
              view(b) -= unit.dot(view(b)) * unit;
            }
        }
    }

    /**
     * The answers as columns of G, with the cones of their coefficients. The functionals P of the
     * forces give the part of the load r that an answer (v, q) meets,
     *
     *     Pᵀr - ρ̇ = Pᵀ W v + (Pᵀ q - ρ̇).
     */
    class Answers
    {
    public:
      Answers(const DenseMatrix &stiffness, const Vector &load, const Vector &row_scales)
        : W(stiffness), r(load), diagonal(row_scales)
      {
      }

      void
      add(const ConeAnswer &answer)
      {
        const TangentVector &e = answer.direction;
        const std::size_t row = answer.row, first = functionals.size();
        switch (answer.place)
          {
            case ConeAnswer::Place::on_cone:
              add_functional(row, {{answer.friction, e[0], e[1]}}, answer);
              add_motion(row, {{answer.rise, e[0], e[1]}}, answer, motions);
              add_force({{first, -1.}}, 0.);
              return;
            case ConeAnswer::Place::parting:
              add_functional(row, {{1., 0., 0.}}, answer);
              add_parting(answer);
              add_force({{first, -1.}}, 0.);
              return;
            case ConeAnswer::Place::at_apex:
              break;
          }
        std::vector<std::pair<std::size_t, double>> pressure_and_shear;
        for (std::size_t i = 0; i <= answer.n_tangents; ++i)
          {
            std::array<double, 3> unit = {{0., 0., 0.}};
            unit[i]                    = 1.;
            add_functional(row, unit, answer);
            pressure_and_shear.emplace_back(first + i,
                                            (i == 0 ? -1. : 1.) * functionals.back().weights[i]);
          }
        add_parting(answer);
        add_force(pressure_and_shear, 1. / answer.friction);
      }

      /** Return the part of the load that is farthest from all answers. */
      std::optional<Vector>
      rest() const
      {
        constexpr double no_rest = 1e-6;
        const std::size_t m      = functionals.size();
        std::vector<ConeBlock> blocks;
        for (std::size_t k = 0; k < motions.size(); ++k)
          blocks.push_back({k, 1, 0.});
        for (const ConeBlock &block : force_blocks)
          blocks.push_back({motions.size() + block.first, block.size, block.friction});

        DenseMatrix G(m, motions.size() + forces.size()), free(m, free_motions.size());
        take_images(motions, G);
        take_images(free_motions, free);
        for (std::size_t k = 0; k < forces.size(); ++k)
          G(forces[k].first, motions.size() + k) = forces[k].second;
        Vector rest        = load();
        const Vector whole = rest;
        project_out(std::move(free), G, rest);
        const std::optional<ConeProgram::Solution> nearest =
          ConeProgram(multiply_transposed(G, G), blocks).solve(multiply_transposed(G, rest));
        if (!nearest)
          return {};
        add_multiple(-1., multiply(G, nearest->z), rest);
        if (!(dot(rest, rest) > no_rest * no_rest * dot(whole, whole)))
          return {};
        Vector y(r.size(), 0.);
        for (std::size_t j = 0; j < m; ++j)
          for (std::size_t i = 0; i < functionals[j].n_rows; ++i)
            y[functionals[j].row + i] += rest[j] * functionals[j].weights[i];
        return y;
      }

    private:
      /** Up to three entries of a vector that contains all rows. */
      struct Triple
      {
        std::size_t row, n_rows;
        std::array<double, 3> weights;
        double right = 0.;
      };

      void
      add_functional(const std::size_t row,
                     const std::array<double, 3> &weights,
                     const ConeAnswer &answer)
      {
        Triple functional{row, answer.n_tangents + 1, weights};
        double size = 0.;
        for (std::size_t i = 0; i < functional.n_rows; ++i)
          size += weights[i] * weights[i] * diagonal[row + i];
        const double scale = 1. / std::sqrt(size);
        for (double &weight : functional.weights)
          weight *= scale;
        functional.right =
          answer.place == ConeAnswer::Place::at_apex ? 0. : scale * answer.strength_rate;
        functionals.push_back(functional);
      }

      static void
      add_motion(const std::size_t row,
                 const std::array<double, 3> &weights,
                 const ConeAnswer &answer,
                 std::vector<Triple> &to)
      {
        to.push_back({row, answer.n_tangents + 1, weights});
      }

      void
      add_parting(const ConeAnswer &answer)
      {
        add_motion(answer.row, {{1., 0., 0.}}, answer, motions);
        for (std::size_t i = 1; i <= answer.n_tangents; ++i)
          {
            std::array<double, 3> unit = {{0., 0., 0.}};
            unit[i]                    = 1.;
            add_motion(answer.row, unit, answer, free_motions);
          }
      }

      void
      add_force(const std::vector<std::pair<std::size_t, double>> &entries, const double friction)
      {
        force_blocks.push_back({forces.size(), entries.size(), friction});
        forces.insert(forces.end(), entries.begin(), entries.end());
      }

      double
      apply(const Triple &functional, const Vector &values) const
      {
        double result = 0.;
        for (std::size_t i = 0; i < functional.n_rows; ++i)
          result += functional.weights[i] * values[functional.row + i];
        return result;
      }

      Vector
      load() const
      {
        Vector result;
        for (const Triple &functional : functionals)
          result.push_back(apply(functional, r) - functional.right);
        return result;
      }

      void
      take_images(const std::vector<Triple> &of, DenseMatrix &images) const
      {
        for (std::size_t k = 0; k < of.size(); ++k)
          {
            Vector lost(r.size(), 0.);
            for (std::size_t i = 0; i < of[k].n_rows; ++i)
              view(lost) += of[k].weights[i] * W.col(of[k].row + i);
            for (std::size_t j = 0; j < functionals.size(); ++j)
              images(j, k) = apply(functionals[j], lost);
          }
      }

      const DenseMatrix &W;
      const Vector &r, &diagonal;
      std::vector<Triple> functionals, motions, free_motions;
      /** Functional and entry of each column of forces. */
      std::vector<std::pair<std::size_t, double>> forces;
      std::vector<ConeBlock> force_blocks;
    };
  } // namespace

  // The part of the load that the nearest answer leaves is normal to the cone of all answers: none
  // of them works on it as the load does.
  std::optional<Vector>
  find_barrier(const DenseMatrix &W,
               const Vector &r,
               const Vector &diagonal,
               const std::vector<ConeAnswer> &of_elements)
  {
    Answers answers(W, r, diagonal);
    for (const ConeAnswer &answer : of_elements)
      answers.add(answer);
    return answers.rest();
  }
} // namespace fuga
