// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_virgin_state_h
#define fuga_contact_virgin_state_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

namespace fuga
{
  /** Return the state of joints that have never carried anything: closed and bonded as far as their
   * strength permits, or open by their initial gaps. */
  JointState
  virgin_state(const std::vector<ContactElement> &elements,
               const std::size_t n_bars,
               const bool has_water);
} // namespace fuga

#endif
