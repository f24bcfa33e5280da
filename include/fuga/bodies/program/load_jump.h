// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_jump_h
#define fuga_bodies_program_load_jump_h

#include <fuga/bodies/program/load_patterns.h>

namespace fuga
{
  /**
   * Throw the InputError for a load that jumps: it tells which load, by which factor, the level of
   * water or ground due to which it is not zero there, and what to write.
   */
  template <int dim>
  [[noreturn]] void
  throw_jump(const ModelDefinition &model,
             const CondensedSystem<dim> &system,
             const LoadFactors::Jump &jump);
} // namespace fuga

#endif
