// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/threads.h>

#include <deal.II/base/multithread_info.h>

#include <dlfcn.h>

namespace fuga
{
  // BLAS is whatever Debian's alternatives point to; OpenBLAS is told by its own function, if it is
  // there.
  void
  set_threads(const unsigned int n)
  {
    dealii::MultithreadInfo::set_thread_limit(n);
    using SetThreads = void (*)(int);
    if (const auto set =
          reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set(static_cast<int>(n));
  }
} // namespace fuga
