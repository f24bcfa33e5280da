// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/motion/step_solvers.h>

namespace fuga
{
  namespace
  {
    /** Add one triangle of the products of the terms of two degrees of freedom. */
    template <typename Terms>
    void
    add_products(const Terms &rows,
                 const Terms &columns,
                 const double value,
                 SymmetricTriplets &matrix)
    {
      for (const auto &row : rows)
        for (const auto &column : columns)
          if (row.coordinate >= column.coordinate)
            {
              matrix.rows.push_back(static_cast<int>(row.coordinate) + 1);
              matrix.columns.push_back(static_cast<int>(column.coordinate) + 1);
              matrix.values.push_back(value * row.factor * column.factor);
            }
    }
  } // namespace

  BodiesWork
  StepSolvers::work() const
  {
    BodiesWork sum;
    for (const std::unique_ptr<SchurSolver> &solver : solvers)
      if (solver)
        {
          sum.n_factorisations += solver->work().n_factorisations;
          sum.n_condensed_loads += solver->work().n_condensed_loads;
          sum.n_solutions += solver->work().n_solutions;
        }
    return sum;
  }


  template <int dim>
  void
  add_by_nodes(const dealii::SparseMatrix<double> &by_nodes,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix)
  {
    std::vector<typename InterfaceCoordinates<dim>::Term> rows, columns;
    for (unsigned int dof = 0; dof < by_nodes.m(); ++dof)
      {
        coordinates.terms_of(dof, rows);
        for (auto entry = by_nodes.begin(dof); entry != by_nodes.end(dof); ++entry)
          if (entry->value() != 0.)
            {
              coordinates.terms_of(entry->column(), columns);
              add_products(rows, columns, entry->value(), matrix);
            }
      }
  }


  template <int dim>
  void
  add_diagonal(const double factor,
               const Vector &diagonal,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix)
  {
    std::vector<typename InterfaceCoordinates<dim>::Term> terms;
    for (std::size_t dof = 0; dof < diagonal.size(); ++dof)
      if (diagonal[dof] != 0.)
        {
          coordinates.terms_of(dof, terms);
          add_products(terms, terms, factor * diagonal[dof], matrix);
        }
  }


  template <int dim>
  void
  add_dashpots(const double factor,
               const Dashpots<dim> &dashpots,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix)
  {
    std::array<std::vector<typename InterfaceCoordinates<dim>::Term>, dim> terms;
    for (const auto &[node, dashpot] : dashpots)
      {
        for (unsigned int c = 0; c < dim; ++c)
          coordinates.terms_of(node * dim + c, terms[c]);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            add_products(terms[c], terms[d], factor * dashpot[c][d], matrix);
      }
  }


  template void
  add_by_nodes(const dealii::SparseMatrix<double> &,
               const InterfaceCoordinates<2> &,
               SymmetricTriplets &);
  template void
  add_diagonal(const double, const Vector &, const InterfaceCoordinates<2> &, SymmetricTriplets &);
  template void
  add_dashpots(const double,
               const Dashpots<2> &,
               const InterfaceCoordinates<2> &,
               SymmetricTriplets &);
  template void
  add_by_nodes(const dealii::SparseMatrix<double> &,
               const InterfaceCoordinates<3> &,
               SymmetricTriplets &);
  template void
  add_diagonal(const double, const Vector &, const InterfaceCoordinates<3> &, SymmetricTriplets &);
  template void
  add_dashpots(const double,
               const Dashpots<3> &,
               const InterfaceCoordinates<3> &,
               SymmetricTriplets &);
} // namespace fuga
