// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "dynamics/moving_springs.h"

namespace fuga::tests
{
  namespace
  {
    TimeIntegration::Damping
    damping_of(const Springs &springs)
    {
      if (springs.damping.size() == 0)
        return [](const Vector &) { return Vector(); };
      return [C = springs.damping](const Vector &v) { return multiply(C, v); };
    }

    Vector
    plus(const Vector &a, const double factor, const Vector &b)
    {
      Vector result = a;
      for (std::size_t i = 0; i < b.size(); ++i)
        result[i] += factor * b[i];
      return result;
    }
  } // namespace

  MovingSprings::MovingSprings(Springs of)
    : springs(std::move(of))
    , jumps(sparse(springs.jumps))
    , integration(springs.masses, damping_of(springs), springs.spectral_radius)
  {
  }

  void
  MovingSprings::begin(const Vector &forces, MotionLedger &ledger)
  {
    first_forces         = forces;
    t                    = 0.;
    const Vector at_rest = Vector(springs.masses.size(), 0.);
    const Vector &v      = springs.velocities.empty() ? at_rest : springs.velocities;
    integration.begin(v, springs.loads(0.));
    ledger.kinetic = integration.kinetic_energy();
    ledger.work    = ledger.kinetic; // of what set the masses in motion
  }

  DenseMatrix
  MovingSprings::condensed_stiffness(const unsigned int rung)
  {
    const double length = springs.length_of(rung);
    DenseMatrix S       = springs.stiffness;
    for (Eigen::Index i = 0; i < S.rows(); ++i)
      {
        S(i, i) += integration.mass_factor(length) * springs.masses[i];
        for (Eigen::Index j = 0; j < S.rows() && springs.damping.size() > 0; ++j)
          S(i, j) += integration.damping_factor(length) * springs.damping(i, j);
      }
    return S;
  }

  MovingBodies::Step
  MovingSprings::begin_step(const unsigned int rung)
  {
    h                    = springs.length_of(rung);
    const auto predicted = integration.predicted(h);
    Vector growth        = plus(springs.loads(t + h), -1., springs.loads(t));
    growth               = plus(growth, -1., multiply(springs.stiffness, predicted.u));
    if (springs.damping.size() > 0)
      growth = plus(growth, -1., multiply(springs.damping, predicted.v));
    return {multiply(springs.jumps, predicted.u), integration.push(growth)};
  }

  void
  MovingSprings::finish_step(const Vector &x, const Vector &, MotionLedger &ledger)
  {
    Vector mean = plus(springs.loads(t), 1., springs.loads(t + h));
    for (double &value : mean)
      value *= 0.5;
    integration.advance(
      h, x, plus(mean, 1., multiply_transposed(springs.jumps, first_forces)), ledger);
    const Vector &u = integration.displacement();
    ledger.bodies   = 0.5 * dot(u, multiply(springs.stiffness, u));
    t += h;
  }

  MotionMemory
  MovingSprings::memory() const
  {
    return {t, first_forces, {}, {integration.memory()}};
  }

  void
  MovingSprings::restore(const MotionMemory &memory)
  {
    t            = memory.time;
    first_forces = memory.first_forces;
    integration.restore(memory.integrations.front());
  }

  struct SpringMotion::Actors
  {
    Actors(const Springs &springs,
           const std::vector<ContactElement> &elements,
           const unsigned int n_steps,
           const unsigned int halvings,
           const double event_tolerance)
      : bodies(springs)
      , at_rest(bodies.condensed_stiffness(0), 0, bodies.jump_operator(), elements)
      , history(StepSystem::history())
      , path(elements,
             at_rest.layered(),
             history,
             bodies,
             {0., 1., n_steps, springs.step, halvings, event_tolerance},
             PathOptions())
      , judge(at_rest, elements, history, 0.)
    {
    }

    MovingSprings bodies;
    StepSystem at_rest;
    LoadHistory history;
    DynamicPath path;
    Judge judge;
  };

  SpringMotion::SpringMotion(const Springs &springs,
                             const std::vector<ContactElement> &elements,
                             const JointState &first,
                             const unsigned int n_steps,
                             const unsigned int halvings,
                             const double event_tolerance)
    : actors(std::make_unique<Actors>(springs, elements, n_steps, halvings, event_tolerance))
  {
    times         = {0.};
    displacements = {Vector(springs.masses.size(), 0.)};
    states        = {first};
    ledgers       = {MotionLedger()};
    std::vector<double> levels;
    for (unsigned int i = 1; i <= n_steps; ++i)
      levels.push_back(static_cast<double>(i) / n_steps);
    PathCut start;
    start.state = first;
    actors->path.go_on(start, levels, *this);
    steps_of_rung = actors->path.n_steps();
  }

  SpringMotion::~SpringMotion() = default;

  void
  SpringMotion::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    actors->judge.follow(from, to, length);
  }

  void
  SpringMotion::jumped(const JointState &)
  {
    actors->judge.lose_track();
  }

  void
  SpringMotion::changed(const std::vector<ContactEvent> &new_events, const JointState &state)
  {
    events.insert(events.end(), new_events.begin(), new_events.end());
    worst.absorb(actors->judge.judge(state));
  }

  void
  SpringMotion::reached(const std::size_t, const JointState &state)
  {
    worst.absorb(actors->judge.judge(state));
    times.push_back(actors->bodies.time());
    displacements.push_back(actors->bodies.motion().displacement());
    states.push_back(state);
    ledgers.push_back(actors->path.energies());
  }

  void
  SpringMotion::began_step(const ContactSystem &system, const LoadHistory &history)
  {
    actors->judge.begin_step(system, history);
  }

  void
  SpringMotion::ended_step(const JointState &state)
  {
    actors->judge.end_step(state);
  }
} // namespace fuga::tests
