// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cone_projection.h>
#include <fuga/contact/judge/judge.h>

#include <algorithm>
#include <cmath>

// The motion that the judge itself finds where that of the solver proves nothing.
namespace fuga
{
  namespace
  {
    /** Share of the largest rigid motion in the joints below which a motion counts as zero; the
     * same holds for a motion on which the load does less than this share of its power on the free
     * bodies. */
    constexpr double no_motion = 1e-7;

    /** Return combinations of the columns of @p motions that are orthonormal in the jumps, as
     * columns. */
    DenseMatrix
    orthonormal_combinations(const DenseMatrix &motions)
    {
      const std::size_t n = motions.cols();
      DenseMatrix scaled  = motions;
      Vector sizes(n, 1.);
      for (std::size_t j = 0; j < n; ++j)
        {
          if (max_abs(motions.col(j)) > 0.)
            sizes[j] = motions.col(j).norm();
          scaled.col(j) /= sizes[j];
        }
      const RightSingularVectors svd(scaled);
      const std::size_t rank =
        std::count_if(svd.values.begin(), svd.values.end(), [&](const double value) {
          return value > no_motion * svd.values.front();
        });
      DenseMatrix result(n, rank);
      for (std::size_t k = 0; k < rank; ++k)
        for (std::size_t j = 0; j < n; ++j)
          result(j, k) = svd.V(j, k) / (sizes[j] * svd.values[k]);
      return result;
    }

    /** Bars with the weights of their jumps in a condition. */
    using Terms = std::vector<std::pair<std::size_t, double>>;

    /** Rows of linear conditions on the jumps, as rows on the amounts of given motions. */
    class Conditions
    {
    public:
      explicit Conditions(const DenseMatrix &jumps_of_motions) : jumps(jumps_of_motions)
      {
      }

      /** Add the condition on Σ weight × jump of the bar. */
      void
      add(const Terms &terms)
      {
        Vector row(jumps.cols(), 0.);
        for (const auto &[bar, weight] : terms)
          for (std::size_t k = 0; k < row.size(); ++k)
            row[k] += weight * jumps(bar, k);
        rows.push_back(row);
      }

      DenseMatrix
      matrix() const
      {
        DenseMatrix result(rows.size(), jumps.cols());
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (Eigen::Index k = 0; k < jumps.cols(); ++k)
            result(i, k) = rows[i][k];
        return result;
      }

    private:
      const DenseMatrix &jumps;
      std::vector<Vector> rows;
    };

    void
    add_conditions_on_parting(const ContactElement &element,
                              const Freedom &freedom,
                              const bool by_friction,
                              Conditions &equal,
                              Conditions &positive)
    {
      positive.add({{element.normal_bar, 1.}});
      if (!by_friction || !element.has_tangential_bar())
        return;
      const std::size_t t = element.tangential_bar, s = element.second_tangential_bar;
      const bool in_space = element.has_second_tangential_bar();
      if (freedom.holds_shear)
        {
          equal.add({{t, 1.}});
          if (in_space)
            equal.add({{s, 1.}});
          return;
        }
      for (const double sign : {-1., 1.})
        {
          const Terms inside = {{element.normal_bar, 1.}, {t, sign * freedom.friction}};
          if (!in_space)
            positive.add(inside);
          else // within the circular cone
            for (const double other : {-1., 1.})
              {
                Terms facet = inside;
                facet.emplace_back(s, other * freedom.friction);
                positive.add(facet);
              }
        }
    }

    void
    add_conditions_on_sliding(const ContactElement &element,
                              const Freedom &freedom,
                              const bool by_friction,
                              Conditions &equal,
                              Conditions &positive)
    {
      const std::size_t n = element.normal_bar, t = element.tangential_bar;
      if (length(freedom.along) == 0.)
        {
          equal.add({{n, 1.}});
          return;
        }
      const TangentVector along = freedom.along, across = normal_to(along);
      Terms slip = {{t, along[0]}};
      if (element.has_second_tangential_bar())
        {
          const std::size_t s = element.second_tangential_bar;
          slip.emplace_back(s, along[1]);
          equal.add({{t, across[0]}, {s, across[1]}});
        }
      positive.add(slip);
      for (auto &term : slip)
        term.second *= by_friction ? -freedom.friction : -freedom.dilatancy;
      slip.emplace_back(n, 1.);
      equal.add(slip);
    }

    /** Add the conditions of an element. With @p by_friction, sliding lips rise, and parting ones
     * rise at least, by the angle of friction. */
    void
    add_conditions(const ContactElement &element,
                   const Freedom &freedom,
                   const bool by_friction,
                   Conditions &equal,
                   Conditions &positive)
    {
      switch (freedom.kind)
        {
          case Freedom::Kind::open:
            return;
          case Freedom::Kind::parting:
            add_conditions_on_parting(element, freedom, by_friction, equal, positive);
            return;
          case Freedom::Kind::sliding:
            add_conditions_on_sliding(element, freedom, by_friction, equal, positive);
            return;
          case Freedom::Kind::none:
            break;
        }
      element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &) {
        equal.add({{bar, 1.}});
      });
    }
  } // namespace

  Vector
  Judge::powers_of_growth(const JointState &state) const
  {
    const DenseMatrix &motions = system->rigid_motions();
    Vector result              = multiply(system->rigid_motion_loads(), growth_of_factors(state));
    Vector released            = state.missing_water;
    released.resize(system->rigid_motions().rows(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        released[element.normal_bar] += state.unreleased[element.normal_bar];
        const TangentVector lost  = lost_shear(k, state);
        const TangentVector force = shear_part(element, state.forces);
        const double falls = element.friction.reduced ? -history->strength_share_rate(state.t) : 0.;
        for (std::size_t i = 1; i < element.n_bars(); ++i)
          released[element.bar(i)] += lost[i - 1] + falls * force[i - 1];
      }
    const Vector by_release = multiply_transposed(motions, released);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += by_release[i];
    return result;
  }

  Vector
  Judge::nearest_motion(const JointState &state,
                        const Motions wanted,
                        const DenseMatrix &jumps_of,
                        const Vector &target) const
  {
    const Vector delta = jumps(state.dislocations, state.forces);
    Conditions equal(jumps_of), positive(jumps_of);
    for (std::size_t k = 0; k < elements.size(); ++k)
      add_conditions(elements[k],
                     freedom(k, state, delta),
                     wanted == Motions::resisted_by_none,
                     equal,
                     positive);
    const Vector amount = nearest_in_cone(equal.matrix(), positive.matrix(), target);
    if (max_abs(amount) <= no_motion * max_abs(target))
      return {};
    Vector result        = multiply(jumps_of, amount);
    const double largest = max_abs(result);
    for (double &jump : result)
      jump /= largest;
    return result;
  }

  // Rigid motions change no force, and the conditions on them are linear: the motion that the load
  // drives most is the projection of the powers on their cone. Where this projection vanishes the
  // load drives none.
  std::optional<Vector>
  Judge::driven_motion(const JointState &state, const Motions wanted) const
  {
    const DenseMatrix &motions = system->rigid_motions();
    if (motions.size() == 0)
      return {};
    const DenseMatrix combinations = orthonormal_combinations(motions);
    const Vector motion =
      nearest_motion(state,
                     wanted,
                     multiply(motions, combinations),
                     multiply_transposed(combinations, powers_of_growth(state)));
    return motion.empty() ? std::optional<Vector>() : motion;
  }

  // Where the load takes the strength away from lips that slide against it, this motion, without
  // the rise of the lips, is the one that decides.
  std::optional<Vector>
  Judge::mechanism(const JointState &state) const
  {
    if (std::optional<Vector> driven = driven_motion(state))
      return driven;
    const std::optional<Vector> rising = driven_motion(state, Motions::resisted_by_none);
    if (!rising)
      return {};
    const DenseMatrix &motions = system->rigid_motions();
    const DenseMatrix jumps_of = multiply(motions, orthonormal_combinations(motions));
    const Vector motion =
      nearest_motion(state, Motions::possible, jumps_of, multiply_transposed(jumps_of, *rising));
    return motion.empty() ? std::optional<Vector>() : motion;
  }
} // namespace fuga
