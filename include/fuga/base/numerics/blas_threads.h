// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_blas_threads_h
#define fuga_base_numerics_blas_threads_h

namespace fuga::blas
{
  /** How many threads the BLAS uses; one where it does not say. */
  int
  threads();

  /** Does nothing where it cannot be told. */
  void
  set_threads(const int n);

  /** One thread as long as this lives: many small products wait for threads longer than they take.
   */
  class OneThread
  {
  public:
    explicit OneThread(const bool wanted) : before(threads())
    {
      if (wanted)
        set_threads(1);
    }

    OneThread(const OneThread &) = delete;

    ~OneThread()
    {
      set_threads(before);
    }

  private:
    const int before;
  };
} // namespace fuga::blas

#endif
