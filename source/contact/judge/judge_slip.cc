// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/judge/judge.h>

#include <algorithm>
#include <cmath>

// The conditions that the judge imposes on slip between two points of a path.
namespace fuga
{
  namespace
  {
    /** Cubics along a piece of the path, one for each of the two tangents. */
    using CubicsInPlane = std::array<CubicOnUnitInterval, 2>;

    /** A smooth piece of the path; quantities along it are cubics of x ∈ [0, 1]. */
    struct Piece
    {
      const PathPoint &from;
      const PathPoint &to;
      const double length;

      CubicOnUnitInterval
      cubic(const double value0, const double rate0, const double value1, const double rate1) const
      {
        return {value0, rate0 * length, value1, rate1 * length};
      }

      CubicOnUnitInterval
      force(const std::size_t bar) const
      {
        return cubic(from.state.forces[bar],
                     from.rates.forces[bar],
                     to.state.forces[bar],
                     to.rates.forces[bar]);
      }
    };

    /** Return whether @p rate turns away from @p chord by more than an angle whose square is
     * rounding. */
    bool
    turns_away(const TangentVector &rate, const TangentVector &chord)
    {
      constexpr double straight = 1e-7;
      return dot(rate, chord) < 0. ||
             std::abs(dot(rate, normal_to(chord))) > straight * length(rate) * length(chord);
    }
  } // namespace

  void
  Judge::check_slip(const PathPoint &from, const PathPoint &to, const double length_of_piece)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        double work = 0.;
        if (!elements[k].has_tangential_bar() || from.state.states[k] == ContactState::stick)
          check_rest(k, from.state, to.state);
        else
          work = work_of_slip(k, from, to, length_of_piece);
        if (from.state.states[k] == ContactState::open)
          work += work_of_unloading(k, from, to, length_of_piece);
        ledger.dissipation += work;
        element_dissipation[k] += work;
        // The force that a broken bond still carries fades whichever way its lips move.
        if (from.state.states[k] != ContactState::open)
          wrong_slip_work = std::max(wrong_slip_work, -work);
      }
  }

  // Where nothing resists the shear a closed element slides, whatever its state is called.
  void
  Judge::check_rest(const std::size_t k, const JointState &from, const JointState &to)
  {
    if (elements[k].has_tangential_bar() && from.strengths[k].resists_shear())
      wrong_rise = std::max(wrong_rise, length(sum(to.slips[k], -1., from.slips[k])));
    check_rise(k, from, to, 0.);
  }

  double
  Judge::along_slip(const std::size_t k, const JointState &state, const TangentVector &v) const
  {
    return elements[k].has_second_tangential_bar() ? length(v) : slip_sign(state.states[k]) * v[0];
  }

  // The work is ∫T·ds + ∫N dω.
  double
  Judge::work_of_slip(const std::size_t k,
                      const PathPoint &from,
                      const PathPoint &to,
                      const double length_of_piece)
  {
    const ContactElement &element = elements[k];
    const Strength &strength      = from.state.strengths[k];
    const bool slipping           = is_slipping(from.state.states[k]);
    const TangentVector slid      = sum(to.state.slips[k], -1., from.state.slips[k]);
    const TangentVector rate0 = slip_rate(k, from), rate1 = slip_rate(k, to);
    const Piece piece{from, to, length_of_piece};
    const auto slip_along = [&](const std::size_t i) {
      return piece.cubic(from.state.slips[k][i], rate0[i], to.state.slips[k][i], rate1[i]);
    };
    const CubicsInPlane slip = {{slip_along(0), slip_along(1)}};
    double result            = work_of(piece.force(element.tangential_bar), slip[0]);
    if (element.has_second_tangential_bar())
      {
        const CubicsInPlane T = {
          {piece.force(element.tangential_bar), piece.force(element.second_tangential_bar)}};
        result += work_of(T[1], slip[1]);
        // The check is made at both ends and in the middle of the piece, where the slopes of the
        // cubics are most accurate.
        if (slipping)
          for (const double x : {0., 0.5, 1.})
            wrong_slip_work = std::max(wrong_slip_work, work_across(T, slip, x));
      }
    if (slipping && strength.dilatancy > 0.)
      result += work_of(piece.force(element.normal_bar),
                        piece.cubic(from.state.dilations[k],
                                    strength.dilatancy * along_slip(k, from.state, rate0),
                                    to.state.dilations[k],
                                    strength.dilatancy * along_slip(k, from.state, rate1)));
    // Slip that goes along its chord at both ends has not turned, though a cubic may overshoot
    // where the rate at one end is many times that at the other.
    const bool turns = turns_away(rate0, slid) || turns_away(rate1, slid);
    const double way = length(slid) + (turns ? detour(slip[0], slip[1]) : 0.);
    check_rise(k, from.state, to.state, slipping ? way : 0.);
    return result;
  }

  TangentVector
  Judge::slip_rate(const std::size_t k, const PathPoint &point) const
  {
    const ContactElement &element = elements[k];
    const TangentVector jump_rate = sum(tangential(element, point.rates.dislocations),
                                        bar_compliance(*element.shear_law, element.area),
                                        tangential(element, point.rates.forces));
    return sum(jump_rate, -1., layer_rates(k, point).shear);
  }

  // The lips rise by tan ψ per slip as long as they may, and never sink.
  void
  Judge::check_rise(const std::size_t k,
                    const JointState &from,
                    const JointState &to,
                    const double way)
  {
    const FrictionLaw &law = elements[k].friction;
    const double rise      = from.strengths[k].dilatancy > 0. ? law.dilatancy * way : 0.;
    wrong_rise             = std::max({wrong_rise,
                                       std::abs(to.dilations[k] - from.dilations[k] - rise),
                                       to.dilations[k] - law.dilation_limit});
  }

  // The work is ∫N do of lips that open while their bond gives up what it still carries; o is the
  // part of the jump that the layer does not account for.
  double
  Judge::work_of_unloading(const std::size_t k,
                           const PathPoint &from,
                           const PathPoint &to,
                           const double length_of_piece) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n           = element.normal_bar;
    if (from.state.unreleased[n] == 0. && to.state.unreleased[n] == 0.)
      return 0.;
    const double D     = bar_compliance(*element.normal_law, element.area);
    const auto opening = [&](const PathPoint &point) {
      return point.state.dislocations[n] + D * point.state.forces[n] - layer(k, point.state).normal;
    };
    const auto rate = [&](const PathPoint &point) {
      return point.rates.dislocations[n] + D * point.rates.forces[n] - layer_rates(k, point).normal;
    };
    const Piece piece{from, to, length_of_piece};
    return work_of(piece.force(n), piece.cubic(opening(from), rate(from), opening(to), rate(to)));
  }
} // namespace fuga
