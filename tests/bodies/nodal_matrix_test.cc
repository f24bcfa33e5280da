// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Products in single precision against those of Trilinos in double precision.

#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/nodal_matrix.h>

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fuga;

namespace
{
  // Three entries in ten are there, so that most blocks lack some, and some rows whole blocks.
  void
  expect_product_of(const unsigned int block_size)
  {
    const Epetra_MpiComm comm(
      MPI_Comm_f2c(static_cast<MPI_Fint>(processes::fortran_communicator())));
    const int n = static_cast<int>(block_size) * 20;
    const Epetra_Map map(n, 0, comm);
    NodalMatrix K(Copy, map, map, n, false);
    std::mt19937 draws(block_size);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column)
        if (row == column || draws() % 10 < 3)
          {
            const double value = number(draws);
            K.InsertMyValues(row, 1, &value, &column);
          }
    K.FillComplete(map, map);
    K.finish(block_size);
    Epetra_MultiVector X(map, 2), Y(map, 2), exact(map, 2);
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < n; ++i)
        X[j][i] = number(draws);
    for (int j = 0; j < 2; ++j)
      K.multiply_roughly(*X(j), *Y(j));
    K.Apply(X, exact);
    // A sum of some 20 products of numbers up to 1, each with a relative error of 6e-8.
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < n; ++i)
        EXPECT_NEAR(Y[j][i], exact[j][i], 2e-6) << i;
  }
} // namespace

TEST(NodalMatrix, ProductInThePlane)
{
  expect_product_of(2);
}

TEST(NodalMatrix, ProductInSpace)
{
  expect_product_of(3);
}
