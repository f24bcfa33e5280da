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
  /** How a stage is cut into steps of time. */
  struct TimeGrid
  {
    /** Load times at which the motion begins and ends. */
    double begin = 0., end = 1.;
    unsigned int n_steps = 1;
    /** Length of a step [s]. */
    double step = 0.;
    /** How often a step may be halved. */
    unsigned int halvings = 0;
    /** Share of the largest energy that the events of a step may cost, or else it is halved. */
    double event_tolerance = 0.;
    /** Share of the largest energy that is kinetic where bodies rest. */
    static constexpr double at_rest = 1e-6;
    /** The motion ends when the bodies have come to rest; the steps are the most there may be. */
    bool until_rest = false;

    /** Length of the steps of a rung, see MovingBodies [s]. */
    double
    length_of(const unsigned int rung) const
    {
      return step / static_cast<double>(1U << rung);
    }
  };

  /**
   * Energies of bodies in motion since it began [MNm], without what the bodies store because they
   * were loaded before. Nothing is lost if
   *
   *     work = kinetic + bodies + damping + joints + numerical + sudden.  (doc/theory.md, section
   * 19)
   */
  struct MotionLedger
  {
    /** Of the loads that have changed, of the ground, and of the forces with which the joints
     * carried the loads before the motion. */
    double work    = 0.;
    double kinetic = 0.;
    double bodies  = 0.;
    /** What dampers and the damping of the bodies have taken. */
    double damping = 0.;
    /** ∫ p·dδ: what the layers have stored and friction has taken. */
    double joints = 0.;
    /** What the integration in time takes: by its own damping, and because its forces of the joints
     * are linear within a step, where those of a path with events are not. */
    double numerical = 0.;
    /** What is lost where nodes without mass are out of balance when the motion begins: they reach
     * their equilibrium at once, however fast they would have to be. */
    double sudden = 0.;
    /** The largest of them so far. */
    double largest = 0.;
    /** Less than this is rounding of what the joints carried before the motion. */
    double rounding = 0.;

    void
    note_largest()
    {
      largest = std::max({largest, std::abs(work), kinetic, bodies, damping, std::abs(joints)});
    }

    /** Of the largest energy, without rounding. */
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

  /** What a TimeIntegration remembers of the steps so far. */
  struct IntegrationMemory
  {
    /** Displacement since the beginning [m], velocity and acceleration. */
    Vector u, v, a;
    /** See TimeIntegration::inertia(). */
    Vector out_of_balance;
    /** See TimeIntegration::steady_velocity(). */
    Vector steady_v;
    /** See TimeIntegration::damping_forces(): the product is needed more than once. */
    Vector damped;
    /** What is out of balance besides. */
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

  /** What MovingBodies remember between two steps. */
  struct MotionMemory
  {
    /** Since the motion began [s]. */
    double time = 0.;
    /** Of the bars when it began, and on the bodies now. */
    Vector first_forces, forces;
    /** Of the bodies, and of what moves beside them. */
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
   * Bodies with inertia between joints, integrated in time by steps of the length h/2^k, k the
   * number of a *rung*. What the contact layer sees of a step is a small linear system in the
   * changes x of the interface coordinates,
   *
   *     Ŝ x + Bᵀ (p - p_n) = g,     δ = δ_n + δ̄ + B x,           (doc/theory.md, section 19)
   *
   * with Ŝ of the stiffness K + a1 C + a0 M, which is the same in all steps of a rung; δ̄ is how far
   * the bodies come if they go on as they move, and the push g is what inertia, damping, the bodies
   * and the growth of the loads leave out of balance then.
   */
  class MovingBodies
  {
  public:
    virtual ~MovingBodies() = default;

    /** The joints carry the forces @p forces when the motion begins, with the energies that are put
     * into @p ledger. */
    virtual void
    begin(const Vector &forces, MotionLedger &ledger) = 0;

    /** Ŝ of a rung. */
    virtual DenseMatrix
    condensed_stiffness(const unsigned int rung) = 0;

    /** B, n_bars x n_coordinates. */
    virtual const SparseOperator &
    jump_operator() const = 0;

    /** From the present time. */
    struct Step
    {
      /** δ̄. */
      Vector jumps;
      /** g. */
      Vector push;
    };

    /** A step of this rung. */
    virtual Step
    begin_step(const unsigned int rung) = 0;

    /** The step begun last goes to its end, with the coordinates @p x and the bars
     * carry @p forces. Brings @p ledger up to date, but for what depends on the path of the joints. */
    virtual void
    finish_step(const Vector &x, const Vector &forces, MotionLedger &ledger) = 0;

    /** From which restore() goes on, bit for bit. */
    virtual MotionMemory
    memory() const = 0;

    virtual void
    restore(const MotionMemory &memory) = 0;
  };
} // namespace fuga

#endif
