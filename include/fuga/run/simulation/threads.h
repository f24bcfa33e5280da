// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_threads_h
#define fuga_run_simulation_threads_h

namespace fuga
{
  /** Set the number of threads that deal.II and the BLAS may use. */
  void
  set_threads(const unsigned int n);
} // namespace fuga

#endif
