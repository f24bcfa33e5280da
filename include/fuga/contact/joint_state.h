// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_joint_state_h
#define fuga_contact_joint_state_h

#include <fuga/base/dense_matrix.h>
#include <fuga/laws/contact_state.h>

namespace fuga
{
  /** Everything that is known of the joints at one load time. */
  struct JointState
  {
    /** Load time. */
    double t = 0.;
    /** The working scheme, per element. */
    std::vector<ContactState> states;
    /** Bar forces p [MN], tension positive. */
    Vector forces;
    /** Dislocations d of the bars [m], see LayeredSystem. */
    Vector dislocations;
    /** Irreversible slip s of each element [m]; follows the jump while the element is open. */
    Vector slips;
    /** Elements whose cohesion is lost: it breaks for good when the element first opens. */
    std::vector<bool> broken;
    /** Shear that an element which has just broken still carries by cohesion [MN], with its sign.
     */
    Vector unreleased_shear;
  };

  /** How a JointState changes per unit of the path parameter. */
  struct JointRates
  {
    Vector forces;
    Vector dislocations;
  };

  /**
   * What drives the joints along one segment: the rate Ṙ of the reactions of the stuck joint, and
   * the rate of the unreleased shear of broken elements, which only falls in size. Both per unit of
   * the path parameter; `release` is empty while loads change.
   */
  struct Drive
  {
    Vector reactions;
    Vector release;
  };
} // namespace fuga

#endif
