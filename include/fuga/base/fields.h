// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_fields_h
#define fuga_base_fields_h

#include <type_traits>

namespace fuga
{
  /**
   * A class whose members a checkpoint has to keep lists them in a function next to its
   * declaration:
   *
   *     template <typename State, typename Visitor, only_for<State, JointState> = 0>
   *     void for_each_field(State &state, Visitor &&visit)
   *     {
   *       auto &[t, forces] = state;
   *       visit("t", t);
   *       visit("forces", forces);
   *     }
   *
   * One function serves reading (State = JointState) and writing (State = const JointState). The
   * structured binding has to name all members: a member that is forgotten does not compile.
   */
  template <typename State, typename Class>
  using only_for = std::enable_if_t<std::is_same_v<std::remove_const_t<State>, Class>, int>;
} // namespace fuga

#endif
