// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_judge_h
#define fuga_contact_judge_judge_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/contact_system.h>
#include <fuga/contact/judge/barrier_certificate.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/judge/judge_memory.h>
#include <fuga/contact/judge/mechanism_certificate.h>
#include <fuga/contact/load_history.h>
#include <fuga/contact/segments/path_segment.h>

#include <optional>

namespace fuga
{
  /** Return @p value relative to @p scale; zero if both are. */
  double
  share(const double value, const double scale);

  /** Return the tangential part of a bar vector for an element; zero without tangential bars. */
  TangentVector
  shear_part(const ContactElement &element, const Vector &of_bars);

  /** Return the unit vector along @p v; zero if @p v is zero. */
  TangentVector
  direction(const TangentVector &v);

  /**
   * The independent judge. It knows the bodies (S, F, B), the elements with their laws and the
   * loads, and checks the results of the solver; it shares no operator, scheme or tolerance with
   * the solver.
   */
  class Judge : private JudgeMemory
  {
  public:
    /** Constructor. Energies are judged relative to the largest load up to @p end_of_loading. */
    Judge(const ContactSystem &system,
          const std::vector<ContactElement> &elements,
          const LoadHistory &history,
          const double end_of_loading);

    Judge(const ContactSystem &system,
          const std::vector<ContactElement> &elements,
          const LoadHistory &history);

    /** Add the work of a smooth piece of the path of the parameter length @p length. */
    void
    follow(const PathPoint &from, const PathPoint &to, const double length);

    /** Note that the path was left: from now on energies are unknown and no longer judged. */
    void
    lose_track();

    /** Judge a state that lies at the end of the part of the path that was followed. */
    Certificate
    judge(const JointState &state);

    /** Judge the motion of the joints with which a path ended in @p state. */
    MechanismCertificate
    judge_mechanism(const JointState &state, const Vector &motion) const;

    /** Judge virtual rates that are meant to show that no rates exist in @p state. The certificate
     * proves nothing while lost strength is given up, with water in the joints, or in motion. */
    BarrierCertificate
    judge_barrier(const JointState &state, const JointRates &barrier) const;

    /** The set of rigid motions of the bodies that is searched. */
    enum class Motions
    {
      /** Motions that the contact allows. */
      possible,
      /** Motions on which no change of the joint forces that friction allows does positive work:
       * sliding lips rise by the angle of friction. */
      resisted_by_none
    };

    /** Return the jumps, the largest being one, of that one of these motions in @p state on which
     * the growing load does most work. Return nothing if it does work on none of them. */
    std::optional<Vector>
    driven_motion(const JointState &state, const Motions motions = Motions::possible) const;

    /** Return the jumps, the largest being one, of a rigid motion that the contact allows in
     * @p state and that proves a limit load if any does. */
    std::optional<Vector>
    mechanism(const JointState &state) const;

    const EnergyLedger &
    energies() const
    {
      return ledger;
    }

    /** Return the work done by friction in each element so far [MNm]. */
    const Vector &
    dissipation() const
    {
      return element_dissipation;
    }

    const JudgeMemory &
    memory() const
    {
      return *this;
    }

    /** Continue judging where another judge of the same problem was. */
    void
    restore(const JudgeMemory &memory)
    {
      static_cast<JudgeMemory &>(*this) = memory;
    }

    /** Continue judging, in @p state, where the judge of an earlier phase of construction was. */
    void
    begin_phase(const JudgeMemory &memory, const JointState &state);

    /** Continue by judging a time step with the given system and loads, in the time of
     * JointState::part_of_step; both arguments must live until the next call. The work on Ŝ,
     * inertia included, then counts as energy of the bodies. */
    void
    begin_step(const ContactSystem &of_step, const LoadHistory &history_of_step);

    /** End the step in @p state, which has been judged if it was to be. */
    void
    end_step(const JointState &state);

    /** Let the bodies come to rest with this energy of deformation; everything else that the steps
     * counted is not stored energy. */
    void
    end_motion(const double energy_of_bodies);

    /** Return the interface coordinates x of the jumps at load time @p t. */
    Vector
    coordinates(const Vector &jumps, const double t) const;

    /** Return the same where nothing is imposed, i.e. for a motion or for rates. */
    Vector
    coordinates(const Vector &jumps) const;

  private:
    /** Return the time in the history, which is that of the loads or of the present step. */
    double
    time(const JointState &state) const
    {
      return in_motion ? state.part_of_step : state.t;
    }

    Vector
    jumps(const Vector &dislocations, const Vector &forces) const;
    /** Return the loads on the interface coordinates without those of water that has entered. */
    Vector
    loads(const double t) const;
    /** Return the forces of water in open elements, as the loads demand; empty without water. */
    Vector
    water(const JointState &state) const;
    /** Add Bᵀ ω. */
    void
    add_water(const JointState &state, Vector &loads) const;
    /** Return the energy of the bodies for coordinates x and the elastic forces S x. */
    double
    energy_of_bodies(const Vector &x, const Vector &elastic) const;
    void
    add_work_of_imposed_jumps(const PathPoint &from, const PathPoint &to, const double length);
    Vector
    resistance(const Vector &x) const;
    double
    body_equilibrium_error(const JointState &state) const;
    /** Return the scale of errors of energy for the largest force @p load of the loads [MNm]. */
    double
    scale_of_energy(const double load);
    /** Return the work of the forces on lips that they move by their own last digits [MNm]. */
    double
    rounding_of_work() const;
    void
    check_element(const std::size_t k,
                  const JointState &state,
                  const Vector &jumps,
                  Certificate &result) const;
    /** Return the slope of the shear strength over the pressing force. */
    double
    slope_of_strength(const std::size_t k, const JointState &state) const;
    Freedom
    freedom(const std::size_t k, const JointState &state, const Vector &delta) const;
    /** Return the part of the jump @p w of an element that contradicts its freedom. */
    double
    inadmissible_jump(const std::size_t k, const Freedom &freedom, const Vector &w) const;
    /** Return the rates of the load factors, as far as the load grows. */
    Vector
    growth_of_factors(const JointState &state) const;
    /** Return the powers of the growing load, of falling strength and of the forces that broken
     * bonds release, on the rigid motions of the bodies. */
    Vector
    powers_of_growth(const JointState &state) const;
    /** Return the wanted combination of the orthonormal columns of @p jumps_of that is nearest to
     * @p target, scaled to a largest jump of one; empty if there is none. */
    Vector
    nearest_motion(const JointState &state,
                   const Motions wanted,
                   const DenseMatrix &jumps_of,
                   const Vector &target) const;
    /** Return the same power on the jumps @p motion, relative to the sum of its terms. */
    double
    drive(const JointState &state, const Vector &motion) const;
    /** Return the shear that a broken bond has lost but still carries; along the force if lips
     * slide. */
    TangentVector
    lost_shear(const std::size_t k, const JointState &state) const;
    void
    check_slip(const PathPoint &from, const PathPoint &to, const double length);
    /** Check that a stuck element does not slip. */
    void
    check_rest(const std::size_t k, const JointState &from, const JointState &to);
    /** Return the work of shear force and rise [MNm] between two points of the path. */
    double
    work_of_slip(const std::size_t k,
                 const PathPoint &from,
                 const PathPoint &to,
                 const double length);
    /** Return the work of the normal force of open lips, which a broken bond still carries. */
    double
    work_of_unloading(const std::size_t k,
                      const PathPoint &from,
                      const PathPoint &to,
                      const double length) const;
    /** Return the rate of slip of an element that slips or is open. */
    TangentVector
    slip_rate(const std::size_t k, const PathPoint &point) const;
    /** Return the part of a force, or of a rate of slip, in the direction in which a slipping
     * element is said to slip: with one tangential bar the state determines it, with two it is that
     * of the vector itself. */
    double
    along_slip(const std::size_t k, const JointState &state, const TangentVector &v) const;
    /** Check the rise of the lips. @p way is the distance that they slid. */
    void
    check_rise(const std::size_t k, const JointState &from, const JointState &to, const double way);
    /** Return the largest normal or tangential part of an element. */
    double
    largest_of_elements(const Vector &of_bars) const;
    void
    check_reduction(const JointState &state, Certificate &result) const;
    void
    check_strength(const std::size_t k, const Strength &left, Certificate &result) const;

    /** Elastic jumps of an element's layer [m], or their rates. */
    struct Layer
    {
      double normal       = 0.;
      TangentVector shear = {{0., 0.}};
    };

    Layer
    layer(const std::size_t k, const JointState &state) const;
    Layer
    layer_rates(const std::size_t k, const PathPoint &point) const;
    /** Return the stiffness of bodies and layer in series for a bar of this compliance [MN/m]. */
    double
    own_stiffness(const std::size_t bar, const double compliance) const;

    /** Virtual dislocations [m] and forces [MN] on which an answer of an element could work. */
    struct VirtualError
    {
      double normal_jump, shear_jump, pull, shear;
    };

    /** Return the errors of the virtual dislocation @p y and the virtual forces. */
    VirtualError
    virtual_error(const Freedom &freedom,
                  const Layer &y,
                  const double pull,
                  const TangentVector &shear) const;
    /** Return the energy stored in an element [MNm]. */
    double
    stored_energy(const std::size_t k, const JointState &state) const;

    void
    take_stiffness();

    const ContactSystem *system;
    const std::vector<ContactElement> &elements;
    const LoadHistory *history;
    RigidBasis rigid_motions;
    /** Dual of B; it gives coordinates from jumps if there are more bars than coordinates. */
    SparseOperator dual;
    /** 2-norms of the rows of S. */
    Vector stiffness_row_norms;
    double largest_load_of_history = 0.;
  };
} // namespace fuga

#endif
