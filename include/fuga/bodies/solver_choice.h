// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solver_choice_h
#define fuga_bodies_solver_choice_h

#include <string>

namespace fuga
{
  /** The method by which the bodies are eliminated; with `automatic`, the program decides. */
  enum class BodySolver
  {
    automatic,
    direct,
    /** Direct with the factor stored in files in the folder for temporary files. */
    direct_on_disk,
    iterative,
    /** Iterative without assembling the stiffness of the interface, which is applied instead. */
    matrix_free
  };

  const char *
  name_of(const BodySolver solver);

  inline bool
  is_direct(const BodySolver solver)
  {
    return solver == BodySolver::direct || solver == BodySolver::direct_on_disk;
  }

  /** The estimated cost of both ways to eliminate the bodies, and the choice. */
  struct SolverEstimate
  {
    /**
     * From the analysis of the factorisation by MUMPS: its memory, and its operations divided by
     * the speed of a core.
     */
    double direct_megabytes  = 0.;
    double on_disk_megabytes = 0.;
    double direct_seconds    = 0.;
    /** Estimated from the entries of the matrix and the number of right-hand sides. */
    double iterative_megabytes = 0.;
    double iterative_seconds   = 0.;
    /** Memory of the machine, free or not. */
    double available_megabytes = 0.;
    BodySolver choice          = BodySolver::direct;

    /** Return one or two lines for the log. */
    std::string
    text() const;
  };

  /** The size of an elimination. */
  struct EliminationSize
  {
    int dimension           = 2;
    std::size_t n_entries   = 0; // of one triangle
    std::size_t n_unknowns  = 0;
    std::size_t n_interface = 0;
    double direct_megabytes = 0.;
    /** Memory that is still needed if the factor is stored in files. */
    double on_disk_megabytes = 0.;
    double direct_operations = 0.;
    /** Whether the stiffness of the interface is not needed. */
    bool may_be_matrix_free = false;
  };

  /**
   * Estimate the cost of both ways. The direct one is chosen if its factor, or what remains of it
   * in memory with the factor in files, fits into the memory of the machine, whatever others use of
   * it now, unless the iterative one is much faster.
   */
  SolverEstimate
  estimate_solvers(const EliminationSize &size);
} // namespace fuga

#endif
