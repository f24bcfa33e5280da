// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_blas_threads_h
#define fuga_base_numerics_blas_threads_h

namespace fuga::blas
{
  /** Return the number of threads that the BLAS uses; 1 if the BLAS cannot be asked. */
  int
  threads();

  /** Set the number of threads of the BLAS; does nothing if the BLAS does not allow it. */
  void
  set_threads(const int n);

  /**
   * Restricts the BLAS to one thread as long as the object lives: many small products wait for
   * threads longer than they take.
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
