// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_limit_proof_h
#define fuga_contact_judge_limit_proof_h

#include <fuga/contact/judge/judge.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/system/layered_system.h>

namespace fuga
{
  /** The proof that a path cannot go on: that of a limit load, or the barrier where it is the only
   * evidence that there is no continuation. */
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
   * Prove a limit load, in the plane and in space. A limit load becomes a verdict if the motion
   * with which the path ended in @p last_state (without states: before its first load) proves it,
   * see MechanismCertificate::proves(). If it does not, the judge looks for a motion that does,
   * which then takes its place in @p result. A path that found no continuation has also met a limit
   * load if there is such a motion; if it merely did not find one (PathResult::tried), it needs
   * such a motion, or a virtual motion that proves that there is none (PathResult::barrier,
   * BarrierCertificate::proves()), or a jump (Jump::shows_instability()). The function does nothing
   * for other verdicts, nor where the motion itself was followed beyond the limit.
   *
   * @throws NumericalFailure if no motion proves a limit load, or a continuation was merely not
   * found.
   */
  LimitProof
  prove_limit(const Judge &judge,
              const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const JointState &last_state,
              PathResult &result);
} // namespace fuga

#endif
