// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_elimination_order_h
#define fuga_bodies_solvers_elimination_order_h

#include <fuga/bodies/joints/interface_coordinates.h>

#include <vector>

namespace fuga
{
  /** One node for every eliminated coordinate: the one it is a displacement of, or that it moves
   * first. */
  template <int dim>
  std::vector<unsigned int>
  owners_of_coordinates(const Discretization<dim> &discretization,
                        const InterfaceCoordinates<dim> &coordinates);

  /** Which nodes share a cell, in the form that METIS reads: those of node i are entries start[i]
   * to start[i + 1] - 1 of the neighbours. */
  struct Graph
  {
    std::vector<int> start = {0}, neighbours;
  };

  /** The nodes in the order of elimination. A SIGTERM that comes meanwhile reaches the program.
   * @throws NumericalFailure if METIS finds none. */
  std::vector<int>
  nested_dissection(Graph graph);

  /**
   * The place of every coordinate in the elimination, numbered from 1 as MUMPS wants it; interface
   * coordinates come last.
   *
   * MUMPS orders by minimum degree when it is to return a Schur complement, whatever ICNTL(7) says.
   * Nested dissection of the graph of nodes by METIS is better.
   */
  template <int dim>
  std::vector<int>
  elimination_order(const Discretization<dim> &discretization,
                    const InterfaceCoordinates<dim> &coordinates);
} // namespace fuga

#endif
