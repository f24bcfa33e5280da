// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_elimination_order_h
#define fuga_bodies_solvers_elimination_order_h

#include <fuga/bodies/joints/interface_coordinates.h>

#include <vector>

namespace fuga
{
  /**
   * Return one node for every eliminated coordinate: the one whose displacement it is, or the first
   * one that it moves.
   */
  template <int dim>
  std::vector<unsigned int>
  owners_of_coordinates(const Discretization<dim> &discretization,
                        const InterfaceCoordinates<dim> &coordinates);

  /**
   * The graph of nodes that share a cell, in the format of METIS: the neighbours of node i are
   * entries start[i] to start[i + 1] - 1 of `neighbours`.
   */
  struct Graph
  {
    std::vector<int> start = {0}, neighbours;
  };

  /**
   * Return the nodes in the order of elimination. A SIGTERM that comes meanwhile reaches the
   * program.
   * @throws NumericalFailure if METIS finds no order.
   */
  std::vector<int>
  nested_dissection(Graph graph);

  /**
   * Return the position of every coordinate in the elimination, numbered from 1 as required by
   * MUMPS; interface coordinates come last.
   *
   * MUMPS orders by minimum degree if it has to return a Schur complement, whatever ICNTL(7) says.
   * Nested dissection of the graph of nodes by METIS is better.
   */
  template <int dim>
  std::vector<int>
  elimination_order(const Discretization<dim> &discretization,
                    const InterfaceCoordinates<dim> &coordinates);
} // namespace fuga

#endif
