// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/not_a_number.h>
#include <fuga/contact/cones/cone_program.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** The part of a vector that belongs to a block, with zeros beyond the size of the block. */
    using Triple = std::array<double, 3>;

    Triple
    part(const ConeBlock &block, const double *x)
    {
      Triple result = {{0., 0., 0.}};
      std::copy_n(x + block.first, block.size, result.begin());
      return result;
    }

    double
    tail(const Triple &a)
    {
      return std::hypot(a[1], a[2]);
    }

    /** Return a₀² - a₁² - a₂², which is positive inside the cone. */
    double
    determinant(const Triple &a)
    {
      return (a[0] - tail(a)) * (a[0] + tail(a));
    }

    double
    dot(const Triple &a, const Triple &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Return Jordan's product a∘b. */
    Triple
    product(const Triple &a, const Triple &b)
    {
      return {{dot(a, b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]}};
    }

    /** Return the x with a∘x = b. */
    Triple
    quotient(const Triple &b, const Triple &a)
    {
      const double x0 = (a[0] * b[0] - a[1] * b[1] - a[2] * b[2]) / determinant(a);
      return {{x0, (b[1] - x0 * a[1]) / a[0], (b[2] - x0 * a[2]) / a[0]}};
    }

    /** Return the share of d, at most 1, after which x leaves the cone: a root of c + 2 b τ + a
     * τ². */
    double
    way_out(const Triple &x, const Triple &d)
    {
      const double a = determinant(d), c = determinant(x);
      const double b            = x[0] * d[0] - x[1] * d[1] - x[2] * d[2];
      const double discriminant = b * b - a * c;
      double way                = d[0] < 0. ? std::min(1., -x[0] / d[0]) : 1.;
      if (discriminant < 0. || (a >= 0. && b >= 0.))
        return way;
      const double root = std::sqrt(discriminant);
      return std::min(way, b <= 0. ? c / (root - b) : (b + root) / -a);
    }

    void
    add(const double factor, const Vector &d, Vector &x)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += factor * d[i];
    }
  } // namespace

  ConeProgram::ConeProgram(const DenseMatrix &M, const std::vector<ConeBlock> &cone_blocks)
    : blocks(cone_blocks), scale(M.rows()), A(M)
  {
    constexpr double rounding = 1e-14;
    const double least =
      std::max(rounding * largest_diagonal(M), std::numeric_limits<double>::min());
    for (const ConeBlock &block : blocks)
      {
        double stiffness = 0.;
        for (std::size_t i = block.first; i < block.first + block.size; ++i)
          stiffness += M(i, i) / static_cast<double>(block.size);
        for (std::size_t i = 0; i < block.size; ++i)
          scale[block.first + i] = 1. / std::sqrt(std::max(stiffness, least));
        if (block.size > 1)
          scale[block.first] *= block.friction;
      }
    for (std::size_t j = 0; j < scale.size(); ++j)
      for (std::size_t i = 0; i < scale.size(); ++i)
        A(i, j) *= scale[i] * scale[j];
  }

  /** Nesterov and Todd's scaling T = Tᵀ of a block, T y = T⁻¹ x: θ times a hyperbolic rotation by
   * w. */
  struct ConeProgram::Scaling
  {
    double theta;
    Triple w;

    Scaling(const Triple &x, const Triple &y)
    {
      const double dx = std::sqrt(determinant(x)), dy = std::sqrt(determinant(y));
      const double size = 2. * std::sqrt(0.5 * (1. + dot(x, y) / (dx * dy)));
      theta             = std::sqrt(dx / dy);
      for (std::size_t i = 0; i < 3; ++i)
        w[i] = (x[i] / dx + (i == 0 ? 1. : -1.) * y[i] / dy) / size;
    }

    Triple
    apply(const double factor, const double sign, const Triple &a) const
    {
      const double along = w[1] * a[1] + w[2] * a[2];
      const double share = sign * a[0] + along / (1. + w[0]);
      return {{factor * (w[0] * a[0] + sign * along),
               factor * (a[1] + share * w[1]),
               factor * (a[2] + share * w[2])}};
    }

    Triple
    times(const Triple &a) const
    {
      return apply(theta, 1., a);
    }

    Triple
    divide(const Triple &a) const
    {
      return apply(1. / theta, -1., a);
    }
  };

  /** Forces x and rates y inside the cones, with the error ρ = A y - b - x of the forces. */
  struct ConeProgram::Iterate
  {
    const ConeProgram &program;
    Vector x, y, rho;

    explicit Iterate(const ConeProgram &of) : program(of), x(of.scale.size(), 0.)
    {
      for (const ConeBlock &block : program.blocks)
        x[block.first] = 1.;
      y = x;
    }

    void
    find_error(const Vector &b)
    {
      rho = multiply(program.A, y);
      add(-1., b, rho);
      add(-1., x, rho);
    }

    /** Return the mean of x·y over the blocks. */
    double
    mean_product() const
    {
      return fuga::dot(x, y) / static_cast<double>(program.blocks.size());
    }

    bool
    is_inside() const
    {
      return std::all_of(program.blocks.begin(), program.blocks.end(), [&](const ConeBlock &block) {
        const Triple force = part(block, x.data()), rate = part(block, y.data());
        return force[0] > tail(force) && rate[0] > tail(rate);
      });
    }

    double
    way_out(const Vector &dx, const Vector &dy) const
    {
      double way = 1.;
      for (const ConeBlock &block : program.blocks)
        way = std::min({way,
                        fuga::way_out(part(block, x.data()), part(block, dx.data())),
                        fuga::way_out(part(block, y.data()), part(block, dy.data()))});
      return way;
    }

    void
    go(const double way, const Vector &dx, const Vector &dy)
    {
      add(way, dx, x);
      add(way, dy, y);
    }

    // Return the place of a block. Either force or rate is inside its cone, or both are on the
    // surface: the larger one decides.
    Place
    place(const ConeBlock &block) const
    {
      const Triple force = part(block, x.data()), rate = part(block, y.data());
      if (rate[0] - tail(rate) > force[0] + tail(force))
        return Place::unloaded;
      return force[0] - tail(force) > rate[0] + tail(rate) ? Place::at_rest : Place::on_surface;
    }
  };

  /**
   * Newton's steps for x∘y = μ e in scaled unknowns, where both are λ = T y = T⁻¹ x:
   *
   *     (T⁻¹A + T) Δy = c - T⁻¹ρ,   Δx = A Δy + ρ,   λ∘c = μ e - λ∘λ - (T⁻¹Δx)∘(T Δy)
   *
   * where the last product is that of the step before. In this form x·y decreases to rounding; with
   * (A + T²) Δy it stays a thousand times larger.
   */
  class ConeProgram::NewtonStep
  {
  public:
    Vector dx, dy;

    explicit NewtonStep(const Iterate &from)
      : iterate(from), blocks(from.program.blocks), scaled_error(from.rho)
    {
      for (const ConeBlock &block : blocks)
        scalings.emplace_back(part(block, iterate.x.data()), part(block, iterate.y.data()));
      divide(scaled_error.data());
      DenseMatrix H = iterate.program.A;
      for (Eigen::Index j = 0; j < H.cols(); ++j)
        divide(H.col(j).data());
      for (std::size_t k = 0; k < blocks.size(); ++k)
        for (std::size_t j = 0; j < blocks[k].size; ++j)
          {
            Triple unit = {{0., 0., 0.}};
            unit[j]     = 1.;
            unit        = scalings[k].times(unit);
            for (std::size_t i = 0; i < blocks[k].size; ++i)
              H(blocks[k].first + i, blocks[k].first + j) += unit[i];
          }
      if (H.allFinite())
        factors.emplace(std::move(H));
    }

    /** Return false where rounding has taken an iterate out of its cone. */
    bool
    is_regular() const
    {
      return factors.has_value();
    }

    void
    find(const double mu)
    {
      Vector c(iterate.y.size());
      for (std::size_t k = 0; k < blocks.size(); ++k)
        {
          const Triple lambda = scalings[k].times(part(blocks[k], iterate.y.data()));
          Triple goal = product(lambda, lambda), second = {{0., 0., 0.}};
          if (!dx.empty())
            second = product(scalings[k].divide(part(blocks[k], dx.data())),
                             scalings[k].times(part(blocks[k], dy.data())));
          for (std::size_t i = 0; i < 3; ++i)
            goal[i] = (i == 0 ? mu : 0.) - goal[i] - second[i];
          goal = quotient(goal, lambda);
          std::copy_n(goal.begin(), blocks[k].size, c.data() + blocks[k].first);
        }
      add(-1., scaled_error, c);
      factors->solve(c);
      dy = std::move(c);
      dx = multiply(iterate.program.A, dy);
      add(1., iterate.rho, dx);
    }

  private:
    void
    divide(double *values) const
    {
      for (std::size_t k = 0; k < blocks.size(); ++k)
        {
          const Triple a = scalings[k].divide(part(blocks[k], values));
          std::copy_n(a.begin(), blocks[k].size, values + blocks[k].first);
        }
    }

    const Iterate &iterate;
    const std::vector<ConeBlock> &blocks;
    std::vector<Scaling> scalings;
    Vector scaled_error;
    std::optional<LuFactors> factors;
  };

  std::optional<ConeProgram::Solution>
  ConeProgram::solve(const Vector &r) const
  {
    constexpr unsigned int max_iterations = 100;
    // Values of x·y of a block, for forces of at most one: at the first one the method stops, and
    // below the second one its stagnation is due to rounding.
    constexpr double tolerance = 1e-14, accepted = 1e-10;
    constexpr double unbounded = 1e9, share_of_way = 0.99, no_way = 1e-10;
    Vector b(scale.size());
    std::transform(r.begin(), r.end(), scale.begin(), b.begin(), std::multiplies<>());
    const double size = std::max(max_abs(b), std::numeric_limits<double>::min());
    for (double &value : b)
      value /= size;

    Iterate iterate(*this);
    bool is_solved = false, is_bounded = true;
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        iterate.find_error(b);
        const double mu = iterate.mean_product();
        is_solved  = mu <= accepted && max_abs(iterate.rho) <= accepted * (1. + max_abs(iterate.y));
        is_bounded = !(max_abs(iterate.y) > unbounded);
        if ((is_solved && mu <= tolerance) || !is_bounded || !iterate.is_inside())
          break;
        NewtonStep step(iterate);
        if (!step.is_regular())
          break;
        step.find(0.);
        Iterate trial = iterate;
        trial.go(iterate.way_out(step.dx, step.dy), step.dx, step.dy);
        constexpr double least_centring = 1e-6;
        step.find(mu * std::clamp(std::pow(trial.mean_product() / mu, 3), least_centring, 1.));
        const double way = std::min(1., share_of_way * iterate.way_out(step.dx, step.dy));
        if (!(way > no_way))
          break;
        iterate.go(way, step.dx, step.dy);
      }
    if (!is_solved && is_bounded)
      return {};
    Solution result;
    result.is_bounded = is_bounded;
    for (const ConeBlock &block : blocks)
      result.places.push_back(iterate.place(block));
    for (std::size_t i = 0; i < scale.size(); ++i)
      {
        result.z.push_back(size * scale[i] * iterate.y[i]);
        result.forces.push_back(size / scale[i] * iterate.x[i]);
      }
    return result;
  }
} // namespace fuga
