// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/process_info.h>
#include <fuga/bodies/solver_choice.h>

namespace fuga
{
  namespace
  {
    /** Measured values (doc/scaling.md); they are correct within a factor of two or three on other
     * machines. */
    constexpr double operations_per_second   = 1.2e10;
    constexpr double seconds_per_entry       = 5e-9;
    constexpr double bytes_per_entry         = 64.;
    constexpr double iterations_in_the_plane = 30.;
    constexpr double iterations_in_space     = 40.;
    /** Number of solutions in two stages with their schemes and their judgement, and for the
     * loads. */
    constexpr double solutions_matrix_free = 30., solutions_of_loads = 6.;
    constexpr double bytes_per_megabyte = 1024. * 1024.;
    /** Share of the machine's memory that may be used; the rest is for the system, the fields and
     * other programs. The memory that is free at the moment does not matter: the same input takes
     * the same solver on a busy day. */
    constexpr double usable_share = 0.7;
    /** Factor of additional time that a factorisation is worth, because every further solution with
     * it costs little. */
    constexpr double worth_of_a_factor = 4.;
  } // namespace


  const char *
  name_of(const BodySolver solver)
  {
    switch (solver)
      {
        case BodySolver::automatic:
          return "automatic";
        case BodySolver::direct:
          return "direct";
        case BodySolver::direct_on_disk:
          return "direct on disk";
        case BodySolver::iterative:
          return "iterative";
        case BodySolver::matrix_free:
          return "iterative matrix-free";
      }
    return "";
  }


  SolverEstimate
  estimate_solvers(const EliminationSize &size)
  {
    const double entries = static_cast<double>(size.n_entries);
    const double m       = static_cast<double>(size.n_interface);
    const bool columns   = !size.may_be_matrix_free || m < solutions_matrix_free;
    const double iterations =
      (size.dimension == 2 ? iterations_in_the_plane : iterations_in_space) *
      (columns ? m + solutions_of_loads : solutions_matrix_free);
    SolverEstimate result;
    result.direct_megabytes  = size.direct_megabytes;
    result.on_disk_megabytes = size.on_disk_megabytes;
    result.direct_seconds    = size.direct_operations / operations_per_second;
    result.iterative_megabytes =
      (bytes_per_entry * entries + (columns ? 8. * m * m : 0.)) / bytes_per_megabyte;
    result.iterative_seconds   = seconds_per_entry * entries * iterations;
    result.available_megabytes = machine_memory_in_megabytes();
    const double usable        = usable_share * result.available_megabytes;
    if (result.on_disk_megabytes > usable ||
        worth_of_a_factor * result.iterative_seconds < result.direct_seconds)
      result.choice = columns ? BodySolver::iterative : BodySolver::matrix_free;
    else if (result.direct_megabytes > usable)
      result.choice = BodySolver::direct_on_disk;
    return result;
  }


  std::string
  SolverEstimate::text() const
  {
    return fmt::format("bodies: {} (direct: {:.0f} MB, on disk: {:.0f} MB, {:.3g} s; iterative: "
                       "{:.0f} MB, {:.3g} s; "
                       "memory of the machine: {:.0f} MB)",
                       name_of(choice),
                       direct_megabytes,
                       on_disk_megabytes,
                       direct_seconds,
                       iterative_megabytes,
                       iterative_seconds,
                       available_megabytes);
  }
} // namespace fuga
