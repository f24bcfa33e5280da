// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas_threads.h>

#include <dlfcn.h>

// BLAS is whatever Debian's alternatives point to; OpenBLAS is controlled by its own functions, if
// they are available.
namespace fuga::blas
{
  int
  threads()
  {
    using Threads = int (*)();
    if (const auto get = reinterpret_cast<Threads>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads")))
      return get();
    return 1;
  }

  void
  set_threads(const int n)
  {
    using SetThreads = void (*)(int);
    if (const auto set =
          reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set(n);
  }
} // namespace fuga::blas
