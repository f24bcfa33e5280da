// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_work_counter_h
#define fuga_base_work_counter_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace fuga
{
  /**
   * Counters of the work of this process, by phase: the same numbers on every machine, however busy
   * it is, so that a test can tell when a run begins to cost more. All counts are kept here; they
   * are made where work is handed to BLAS, LAPACK, MUMPS and the file system. Not thread-safe: one
   * thread counts.
   */
  namespace work
  {
    enum class Phase : unsigned char
    {
      /** Start, mesh, assembly, and everything that is in no other phase. */
      model,
      elimination,
      loads,
      layered_system,
      path,
      judge,
      results
    };

    constexpr std::size_t n_phases = 7;

    const char *
    name_of(const Phase phase);

    struct Counts
    {
      /**
       * Multiply-add operations in products, factorisations and solutions with dense matrices, in
       * double and in a higher precision.
       */
      std::uint64_t dense_operations     = 0;
      std::uint64_t accurate_operations  = 0;
      std::uint64_t dense_factorisations = 0;
      std::uint64_t dense_solutions      = 0;
      /** Operations of the elimination as counted by MUMPS. */
      std::uint64_t sparse_operations = 0;
      /** Number of right-hand sides condensed or solved with the factors of the bodies. */
      std::uint64_t sparse_columns = 0;
      std::uint64_t bytes_written  = 0;
      /** Processor time [s], which does differ from run to run. */
      double cpu_seconds = 0.;
    };

    /**
     * All work is counted in a phase as long as an object of this class lives; then in the previous
     * one again.
     */
    class Scope
    {
    public:
      explicit Scope(const Phase phase);
      ~Scope();
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      const std::size_t before;
    };

    namespace internal
    {
      extern std::array<Counts, n_phases> counts;
      extern std::size_t current;
    } // namespace internal

    /** Return the counts of the present phase. */
    inline Counts &
    now()
    {
      return internal::counts[internal::current];
    }

    /** Return the counts of all phases up to this moment. */
    const std::array<Counts, n_phases> &
    all();
  } // namespace work
} // namespace fuga

#endif
