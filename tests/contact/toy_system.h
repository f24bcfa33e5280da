// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_toy_system_h
#define fuga_tests_contact_toy_system_h

#include "sparse.h"

#include <fuga/contact/contact_system.h>
#include <fuga/contact/judge/judge.h>
#include <fuga/contact/path/event_path.h>

#include <memory>

namespace fuga::tests
{
  /** A contact system made of given matrices: the contact layer runs on it as on a finite element
   * model. */
  class ToySystem : public ContactSystem
  {
  public:
    DenseMatrix S, F, B, motions, motion_loads;
    std::shared_ptr<const WaterInJoints> water;

    const DenseMatrix &
    stiffness() const override
    {
      return S;
    }

    const DenseMatrix &
    load_patterns() const override
    {
      return F;
    }

    /** Of B when it is asked for first. */
    const SparseOperator &
    jump_operator() const override
    {
      if (B.size() > 0 && its_operator.is_identity())
        its_operator = sparse(B);
      return its_operator;
    }

    const DenseMatrix &
    rigid_motions() const override
    {
      return motions;
    }

    const DenseMatrix &
    rigid_motion_loads() const override
    {
      return motion_loads;
    }

    const WaterInJoints *
    water_in_joints() const override
    {
      return water.get();
    }

  private:
    mutable SparseOperator its_operator;
  };

  /** Water that has the force Q a in every open element with two bars: all lie at the reservoir. */
  class ToyWater : public WaterInJoints
  {
  public:
    explicit ToyWater(DenseMatrix forces_of_open) : Q(std::move(forces_of_open))
    {
      const std::size_t n = Q.rows() / 2;
      its_network.neighbours.resize(n);
      its_network.upstream = its_network.wet = std::vector<bool>(n, true);
      its_network.downstream                 = std::vector<bool>(n, false);
    }

    const WaterNetwork &
    network() const override
    {
      return its_network;
    }

    Vector
    forces(const std::vector<WaterAccess> &access, const Vector &factors) const override
    {
      Vector result = multiply(Q, factors);
      for (std::size_t k = 0; k < access.size(); ++k)
        if (access[k] == WaterAccess::seepage)
          result[2 * k] = 0.;
      return result;
    }

  private:
    DenseMatrix Q;
    WaterNetwork its_network;
  };

  /** Keeps all that a path reports, and has every event and level judged. */
  class Record : public PathObserver
  {
  public:
    Record(const ContactSystem &system,
           const std::vector<ContactElement> &elements,
           const LoadHistory &history)
      : judge(system, elements, history)
    {
    }

    std::vector<ContactEvent> events;
    std::vector<JointState> levels;
    Certificate worst;
    Judge judge;
    /** Of the last event or level. */
    JointState last;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      judge.follow(from, to, length);
    }

    void
    jumped(const JointState &) override
    {
      judge.lose_track();
    }

    void
    changed(const std::vector<ContactEvent> &new_events, const JointState &state) override
    {
      events.insert(events.end(), new_events.begin(), new_events.end());
      worst.absorb(judge.judge(state));
      last = state;
    }

    void
    reached(const std::size_t, const JointState &state) override
    {
      levels.push_back(state);
      worst.absorb(judge.judge(state));
      last = state;
    }
  };

  /** Elements with two bars each (rows 2k, 2k+1), equal laws and areas, kept together with their
   * laws. */
  struct ToyJoint
  {
    std::unique_ptr<ComplianceLaw> normal, shear;
    std::vector<ContactElement> elements;

    ToyJoint(const std::size_t n,
             const double area,
             std::unique_ptr<ComplianceLaw> normal_law,
             std::unique_ptr<ComplianceLaw> shear_law,
             const FrictionLaw &friction)
      : normal(std::move(normal_law)), shear(std::move(shear_law)), elements(n)
    {
      for (std::size_t k = 0; k < n; ++k)
        {
          elements[k].normal_bar     = static_cast<unsigned int>(2 * k);
          elements[k].tangential_bar = static_cast<unsigned int>(2 * k + 1);
          elements[k].number         = static_cast<unsigned int>(k);
          elements[k].area           = area;
          elements[k].normal_law     = normal.get();
          elements[k].shear_law      = shear.get();
          elements[k].friction       = friction;
        }
    }
  };

  /** A rigid block (motions: ux, uy, rotation about the middle of its base) whose base is divided
   * into n equal elements, with a contact element at each of the n + 1 nodes. */
  ToySystem
  rigid_block(const std::size_t n, const double base);

  /** One element pressed by load 0; load 1 shears it together with a spring of stiffness @p k. */
  ToySystem
  spring_beside_joint(const double k);

  /** The joint of that block: nodal areas base/n, half at the ends. */
  ToyJoint
  rigid_block_joint(const std::size_t n,
                    const double base,
                    std::unique_ptr<ComplianceLaw> normal_law,
                    std::unique_ptr<ComplianceLaw> shear_law,
                    const FrictionLaw &friction);
} // namespace fuga::tests

#endif
