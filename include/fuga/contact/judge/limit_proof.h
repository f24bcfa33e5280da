// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_limit_proof_h
#define fuga_contact_judge_limit_proof_h

#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/system/layered_system.h>

namespace fuga
{
  /**
   * What makes a limit load a verdict, in the plane and in space: the motion with which the path
   * ended in @p last_state (without states: before its first load) must prove it, see
   * MechanismCertificate::proves(). If it does not, the judge looks for one that does, which then
   * takes its place in @p result. A path that found no continuation has met a limit load all the
   * same if there is such a motion; if it cannot say that there is no continuation
   * (PathResult::tried), it needs one. Does nothing for other verdicts, nor where the motion itself
   * was followed beyond the limit.
   * @throws NumericalFailure if no motion proves a limit load, or what was only not found.
   */
  MechanismCertificate
  prove_limit(const Judge &judge,
              const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const JointState &last_state,
              PathResult &result);
} // namespace fuga

#endif
