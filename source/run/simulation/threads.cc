// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas_threads.h>
#include <fuga/run/simulation/threads.h>

#include <deal.II/base/multithread_info.h>

namespace fuga
{
  void
  set_threads(const unsigned int n)
  {
    dealii::MultithreadInfo::set_thread_limit(n);
    blas::set_threads(static_cast<int>(n));
  }
} // namespace fuga
