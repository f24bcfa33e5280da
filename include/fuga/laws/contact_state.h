// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_contact_state_h
#define fuga_laws_contact_state_h

#include <string_view>

namespace fuga
{
  /** The state of a contact element. The states of all elements together are the working scheme. */
  enum class ContactState
  {
    /** The lips are apart: N = T = 0, gap ≥ 0. */
    open,
    /** Closed, and the slip does not change: |T| ≤ f|N| + cA. */
    stick,
    /** Closed, T = +(f|N| + cA), the slip grows in the positive tangential direction. */
    slip_forward,
    /** Closed, T = -(f|N| + cA), the slip grows in the negative tangential direction. */
    slip_backward
  };

  constexpr bool
  is_slipping(const ContactState state)
  {
    return state == ContactState::slip_forward || state == ContactState::slip_backward;
  }

  /** Return +1 or -1, and 0 for a state without slip. */
  constexpr double
  slip_sign(const ContactState state)
  {
    return state == ContactState::slip_forward    ? 1.
           : state == ContactState::slip_backward ? -1.
                                                  : 0.;
  }

  /** Return the word used in every output: open, stick or slip. */
  constexpr std::string_view
  state_name(const ContactState state)
  {
    return state == ContactState::open ? "open" : state == ContactState::stick ? "stick" : "slip";
  }

  /** Return the number used in every output: 0 open, 1 stick, 2 slip. */
  constexpr int
  state_code(const ContactState state)
  {
    return state == ContactState::open ? 0 : state == ContactState::stick ? 1 : 2;
  }
} // namespace fuga

#endif
