// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_limit_proof_h
#define fuga_contact_judge_limit_proof_h

#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/system/layered_system.h>

namespace fuga
{
  /** What proves that a path cannot go on: the one of a limit load, or the other one where that is
   * all that shows that there is no continuation. */
  struct LimitProof
  {
    MechanismCertificate mechanism;
    BarrierCertificate barrier;

    bool
    proves() const
    {
      return mechanism.proves() || barrier.proves();
    }
  };

  /**
   * What makes a limit load a verdict, in the plane and in space: the motion with which the path
   * ended in @p last_state (without states: before its first load) must prove it, see
   * MechanismCertificate::proves(). If it does not, the judge looks for one that does, which then
   * takes its place in @p result. A path that found no continuation has met a limit load all the
   * same if there is such a motion; if it has only not found any (PathResult::tried), it needs one,
   * or a virtual motion that proves that there is none (PathResult::barrier,
   * BarrierCertificate::proves()), or a jump (Jump::shows_instability()). Does nothing for other
   * verdicts, nor where the motion itself was followed beyond the limit.
   * @throws NumericalFailure if no motion proves a limit load, or what was only not found.
   */
  LimitProof
  prove_limit(const Judge &judge,
              const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const JointState &last_state,
              PathResult &result);
} // namespace fuga

#endif
