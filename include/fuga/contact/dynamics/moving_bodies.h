// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_moving_bodies_h
#define fuga_contact_dynamics_moving_bodies_h

#include <fuga/base/fields.h>
#include <fuga/base/numerics/sparse_operator.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  /** The division of a stage into time steps. */
  struct TimeGrid
  {
    /** Load times at which the motion begins and ends. */
    double begin = 0., end = 1.;
    unsigned int n_steps = 1;
    /** Length of a step [s]. */
    double step = 0.;
    /** Number of times that a step may be halved. */
    unsigned int halvings = 0;
    /** Share of the largest energy that the events of a step may cost; otherwise the step is
     * halved. */
    double event_tolerance = 0.;
    /** Share of the largest energy below which the kinetic energy is that of bodies at rest. */
    static constexpr double at_rest = 1e-6;
    /** True if the motion ends when the bodies have come to rest; n_steps is then an upper
     * bound. */
    bool until_rest = false;

    /** Return the length of the steps of a rung, see MovingBodies [s]. */
    double
    length_of(const unsigned int rung) const
    {
      return step / static_cast<double>(1U << rung);
    }
  };

  /**
   * Energies of bodies in motion since it began [MNm], without the energy that the bodies store
   * because they were loaded before. No energy is lost if (doc/theory.md, section 19)
   *
   *     work = kinetic + bodies + damping + joints + numerical + sudden.
   */
  struct MotionLedger
  {
    /** Work of the changes of the loads, of the ground, and of the forces with which the joints
     * carried the loads before the motion. */
    double work    = 0.;
    double kinetic = 0.;
    double bodies  = 0.;
    /** Energy that dampers and the damping of the bodies have taken. */
    double damping = 0.;
    /** ∫ p·dδ: the energy that the layers have stored and friction has taken. */
    double joints = 0.;
    /** Energy that the time integration takes: by its own damping, and because its joint forces are
     * linear within a step while those of a path with events are not. */
    double numerical = 0.;
    /** Energy that is lost where nodes without mass are out of balance when the motion begins: they
     * reach their equilibrium at once, however fast they would have to be. */
    double sudden = 0.;
    /** The largest of these energies so far. */
    double largest = 0.;
    /** Energies below this value are rounding of the forces and jumps of the joints before the
     * motion. */
    double rounding = 0.;

    void
    note_largest()
    {
      largest = std::max({largest, std::abs(work), kinetic, bodies, damping, std::abs(joints)});
    }

    /** Return @p energy as a share of the largest energy, without rounding. */
    double
    share(const double energy) const
    {
      return largest > 0. ? std::max(std::abs(energy) - rounding, 0.) / largest : 0.;
    }

    double
    defect() const
    {
      return work - kinetic - bodies - damping - joints - numerical - sudden;
    }
  };

  template <typename Ledger, typename Visitor, only_for<Ledger, MotionLedger> = 0>
  void
  for_each_field(Ledger &ledger, Visitor &&visit)
  {
    auto &[work, kinetic, bodies, damping, joints, numerical, sudden, largest, rounding] = ledger;
    visit("work", work);
    visit("kinetic", kinetic);
    visit("bodies", bodies);
    visit("damping", damping);
    visit("joints", joints);
    visit("numerical", numerical);
    visit("sudden", sudden);
    visit("largest", largest);
    visit("rounding", rounding);
  }

  /** The data that a TimeIntegration remembers of the steps so far. */
  struct IntegrationMemory
  {
    /** Displacement since the beginning [m], velocity and acceleration. */
    Vector u, v, a;
    /** See TimeIntegration::inertia(). */
    Vector out_of_balance;
    /** See TimeIntegration::steady_velocity(). */
    Vector steady_v;
    /** See TimeIntegration::damping_forces(); stored since the product is needed more than once. */
    Vector damped;
    /** The remaining forces that are out of balance. */
    Vector defect;
  };

  template <typename Memory, typename Visitor, only_for<Memory, IntegrationMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[u, v, a, out_of_balance, steady_v, damped, defect] = memory;
    visit("u", u);
    visit("v", v);
    visit("a", a);
    visit("out_of_balance", out_of_balance);
    visit("steady_v", steady_v);
    visit("damped", damped);
    visit("defect", defect);
  }

  /** The data that MovingBodies remember between two steps. */
  struct MotionMemory
  {
    /** Time since the motion began [s]. */
    double time = 0.;
    /** Forces of the bars when the motion began, and forces that act on the bodies now. */
    Vector first_forces, forces;
    /** Time integrations of the bodies, and of what moves beside them. */
    std::vector<IntegrationMemory> integrations;
  };

  template <typename Memory, typename Visitor, only_for<Memory, MotionMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[time, first_forces, forces, integrations] = memory;
    visit("time", time);
    visit("first_forces", first_forces);
    visit("forces", forces);
    visit("integrations", integrations);
  }

  /**
   * Bodies with inertia between joints, integrated in time by steps of the length h/2^k, where k is
   * the number of a *rung*. The contact layer sees a step as a small linear system in the changes x
   * of the interface coordinates,
   *
   *     Ŝ x + Bᵀ (p - p_n) = g,     δ = δ_n + δ̄ + B x,           (doc/theory.md, section 19)
   *
   * where Ŝ is condensed from the stiffness K + a1 C + a0 M and is the same in all steps of a rung;
   * δ̄ are the jumps that result if the bodies go on as they move, and the push g is the imbalance
   * that inertia, damping, the bodies and the growth of the loads then leave.
   */
  class MovingBodies
  {
  public:
    virtual ~MovingBodies() = default;

    /** Begin the motion while the joints carry @p forces, and put its initial energies into
     * @p ledger. */
    virtual void
    begin(const Vector &forces, MotionLedger &ledger) = 0;

    /** Return the condensed stiffness Ŝ of a rung. */
    virtual DenseMatrix
    condensed_stiffness(const unsigned int rung) = 0;

    /** Return B, n_bars x n_coordinates. */
    virtual const SparseOperator &
    jump_operator() const = 0;

    /** A step from the present time. */
    struct Step
    {
      /** The jumps δ̄. */
      Vector jumps;
      /** The push g. */
      Vector push;
    };

    /** Begin a step of this rung. */
    virtual Step
    begin_step(const unsigned int rung) = 0;

    /** Complete the step begun last, with the coordinates @p x and bars that carry @p forces.
     * Update @p ledger, except for the terms that depend on the path of the joints. */
    virtual void
    finish_step(const Vector &x, const Vector &forces, MotionLedger &ledger) = 0;

    /** Return the data from which restore() goes on, bit for bit. */
    virtual MotionMemory
    memory() const = 0;

    virtual void
    restore(const MotionMemory &memory) = 0;
  };
} // namespace fuga

#endif
