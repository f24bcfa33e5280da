// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_dynamics_moving_springs_h
#define fuga_tests_dynamics_moving_springs_h

#include "sparse.h"

#include <fuga/contact/dynamics/dynamic_path.h>
#include <fuga/contact/dynamics/time_integration.h>
#include <fuga/contact/judge/judge.h>

#include <functional>
#include <memory>

namespace fuga::tests
{
  /** Masses on springs, with contact elements between them or to the ground. */
  struct Springs
  {
    Vector masses;
    /** K and C; C may be empty. */
    DenseMatrix stiffness, damping;
    /** Jumps of the bars from the displacements. */
    DenseMatrix jumps;
    /** Forces on the masses beyond those that the joints carry at the beginning. */
    std::function<Vector(const double t)> loads;
    Vector velocities;
    double step            = 0.;
    double spectral_radius = 1.;

    /** Length of the steps of a rung. */
    double
    length_of(const unsigned int rung) const
    {
      return step / static_cast<double>(1U << rung);
    }
  };

  class MovingSprings : public MovingBodies
  {
  public:
    explicit MovingSprings(Springs springs);

    void
    begin(const Vector &forces, MotionLedger &ledger) override;
    DenseMatrix
    condensed_stiffness(const unsigned int rung) override;
    const SparseOperator &
    jump_operator() const override
    {
      return jumps;
    }
    Step
    begin_step(const unsigned int rung) override;
    void
    finish_step(const Vector &x, const Vector &forces, MotionLedger &ledger) override;
    MotionMemory
    memory() const override;
    void
    restore(const MotionMemory &memory) override;

    const TimeIntegration &
    motion() const
    {
      return integration;
    }

    double
    time() const
    {
      return t;
    }

  private:
    const Springs springs;
    const SparseOperator jumps;
    TimeIntegration integration;
    Vector first_forces;
    double t = 0., h = 0.;
  };

  /** A motion of springs, observed and judged. */
  class SpringMotion : public PathObserver
  {
  public:
    /** The elements carry @p first when the motion begins, which lasts @p n_steps steps. */
    SpringMotion(const Springs &springs,
                 const std::vector<ContactElement> &elements,
                 const JointState &first,
                 const unsigned int n_steps,
                 const unsigned int halvings  = 5,
                 const double event_tolerance = 1e-6);

    ~SpringMotion() override;

    /** At the ends of the steps of the grid, from the beginning. */
    std::vector<double> times;
    std::vector<Vector> displacements;
    std::vector<JointState> states;
    std::vector<MotionLedger> ledgers;
    std::vector<ContactEvent> events;
    std::vector<std::size_t> steps_of_rung;
    Certificate worst;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &new_events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;
    void
    began_step(const ContactSystem &system, const LoadHistory &history) override;
    void
    ended_step(const JointState &state) override;

  private:
    struct Actors;
    std::unique_ptr<Actors> actors;
  };
} // namespace fuga::tests

#endif
