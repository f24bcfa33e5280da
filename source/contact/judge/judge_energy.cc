// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/base/work_counter.h>
#include <fuga/contact/judge/judge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /**
     * Return ∫b ẋ over a piece in which the load time has grown by @p growth: the additional work
     * of loads, of which a unit of the load time adds @p load, compared with loads that grow in
     * proportion; b is the cubic difference between these and the curve of the load time.
     */
    double
    work_of_bend(const PathPoint &from,
                 const PathPoint &to,
                 const double length,
                 const double growth,
                 const Vector &load,
                 const std::array<Vector, 2> &x,
                 const std::array<Vector, 2> &rates)
    {
      const CubicOnUnitInterval bend(
        0., length * *from.load_rate - growth, 0., length * *to.load_rate - growth);
      const double r           = std::sqrt(0.15);
      const double abscissae[] = {0.5 - r, 0.5, 0.5 + r};
      const double weights[]   = {5. / 18., 8. / 18., 5. / 18.};
      double work              = 0.;
      for (std::size_t i = 0; i < load.size(); ++i)
        {
          const CubicOnUnitInterval jump(
            x[0][i], length * rates[0][i], x[1][i], length * rates[1][i]);
          for (int g = 0; g < 3; ++g)
            work += load[i] * weights[g] * bend.value(abscissae[g]) * jump.slope(abscissae[g]);
        }
      return work;
    }
  } // namespace

  // The loads are linear along a piece, except for work_of_bend(), and the jumps are cubics (exact
  // for straight pieces), so that ∫f·dx = f0·Δx + Δf·(x1 - ∫x ds) on s ∈ [0, 1].
  void
  Judge::follow(const PathPoint &from, const PathPoint &to, const double length)
  {
    const work::Scope phase(work::Phase::judge);
    const Vector delta0 = jumps(from.state.dislocations, from.state.forces),
                 delta1 = jumps(to.state.dislocations, to.state.forces);
    largest_jump =
      std::max({largest_jump, largest_of_elements(delta0), largest_of_elements(delta1)});
    const Vector x0 = coordinates(delta0, time(from.state)),
                 x1 = coordinates(delta1, time(to.state));
    // Imposed jumps have one rate along the piece, which the difference of both rates does not
    // contain.
    const Vector v0 = coordinates(jumps(from.rates.dislocations, from.rates.forces));
    const Vector v1 = coordinates(jumps(to.rates.dislocations, to.rates.forces));
    Vector f0 = loads(time(from.state)), f1 = loads(time(to.state));
    add_water(from.state, f0);
    add_water(to.state, f1);
    for (std::size_t i = 0; i < system->carried_load().size(); ++i)
      {
        f0[i] -= system->carried_load()[i];
        f1[i] -= system->carried_load()[i];
      }
    for (std::size_t i = 0; i < x0.size(); ++i)
      {
        const double mean = 0.5 * (x0[i] + x1[i]) + length / 12. * (v0[i] - v1[i]);
        ledger.external_work += f0[i] * (x1[i] - x0[i]) + (f1[i] - f0[i]) * (x1[i] - mean);
      }
    if (from.load_rate && to.load_rate)
      ledger.external_work +=
        work_of_bend(from,
                     to,
                     length,
                     time(to.state) - time(from.state),
                     multiply(system->load_patterns(), history->rates(time(from.state))),
                     {{x0, x1}},
                     {{v0, v1}});
    add_work_of_imposed_jumps(from, to, length);
    check_slip(from, to, length);
  }

  // The work is ∫p·E da, done by the forces of the bars when the lips are put apart, or are taken
  // off.
  void
  Judge::add_work_of_imposed_jumps(const PathPoint &from, const PathPoint &to, const double length)
  {
    const DenseMatrix &E = system->imposed_jumps();
    if (E.size() == 0)
      return;
    const Vector e0 = multiply(E, history->factors(time(from.state))),
                 e1 = multiply(E, history->factors(time(to.state)));
    for (std::size_t i = 0; i < e0.size(); ++i)
      ledger.external_work +=
        (e1[i] - e0[i]) * (0.5 * (from.state.forces[i] + to.state.forces[i]) +
                           length / 12. * (from.rates.forces[i] - to.rates.forces[i]));
  }

  void
  Judge::lose_track()
  {
    on_track             = false;
    ledger.external_work = ledger.dissipation = std::numeric_limits<double>::quiet_NaN();
    element_dissipation.assign(elements.size(), std::numeric_limits<double>::quiet_NaN());
  }

  double
  Judge::energy_of_bodies(const Vector &x, const Vector &elastic) const
  {
    double energy = energy_of_bodies_before + 0.5 * dot(x, elastic);
    if (!system->carried_load().empty())
      energy -= dot(x, system->carried_load());
    return energy;
  }

  void
  Judge::begin_step(const ContactSystem &of_step, const LoadHistory &history_of_step)
  {
    history        = &history_of_step;
    largest_force  = std::max(largest_force, of_step.force_scale());
    largest_energy = std::max(largest_energy, of_step.energy_scale());
    if (system == &of_step)
      return;
    if (!in_motion)
      {
        energy_of_bodies_before = ledger.bodies;
        at_rest                 = ledger;
      }
    in_motion     = true;
    system        = &of_step;
    rigid_motions = RigidBasis(of_step);
    take_stiffness();
  }

  // A step measures its coordinates from its beginning.
  void
  Judge::end_step(const JointState &state)
  {
    const Vector x = coordinates(jumps(state.dislocations, state.forces), time(state));
    energy_of_bodies_before += 0.5 * dot(x, resistance(x));
  }

  void
  Judge::end_motion(const double energy_of_bodies)
  {
    ledger.bodies        = energy_of_bodies;
    ledger.external_work = ledger.bodies + ledger.layer + ledger.dissipation;
  }

  // The energy of layers that are removed with their bodies is extracted from outside.
  void
  Judge::begin_phase(const JudgeMemory &memory, const JointState &state)
  {
    restore(memory);
    in_motion = false;
    ledger.external_work -= ledger.layer;
    for (std::size_t k = 0; k < elements.size(); ++k)
      ledger.external_work += stored_energy(k, state);
    if (!system->has_stiffness())
      return; // begin_step() does the rest
    const Vector x          = coordinates(jumps(state.dislocations, state.forces), time(state));
    energy_of_bodies_before = 0.;
    energy_of_bodies_before = ledger.bodies - energy_of_bodies(x, multiply(system->stiffness(), x));
  }

  // Early in a run energies are small, and so would be the scale; but the load still to come is
  // known.
  double
  Judge::scale_of_energy(const double load)
  {
    largest_energy = std::max({largest_energy,
                               std::abs(ledger.external_work),
                               std::abs(ledger.bodies),
                               ledger.layer,
                               ledger.dissipation});
    largest_load   = std::max(largest_load, load);
    const double ratio =
      largest_load > 0. ? std::max(1., largest_load_of_history / largest_load) : 1.;
    return largest_energy * ratio * ratio;
  }

  // Lips move by the last digits of the forces, and the forces do work on that, even on the
  // stiffest lips. Where rigid joints begin to slip together, nothing else has done work yet.
  double
  Judge::rounding_of_work() const
  {
    constexpr double rounding = 16. * std::numeric_limits<double>::epsilon();
    const double stiffness    = max_abs(stiffness_row_norms);
    return stiffness > 0. ? rounding * largest_force * largest_force / stiffness : 0.;
  }
} // namespace fuga
