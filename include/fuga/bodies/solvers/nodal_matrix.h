// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_nodal_matrix_h
#define fuga_bodies_solvers_nodal_matrix_h

#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>

#include <vector>

namespace fuga
{
  /**
   * A matrix whose rows and columns come in blocks of one node each. For the smoother of multigrid
   * it has a second product in single precision, which reads the position of a column only once per
   * block: 40 bytes for nine entries in space, where Epetra_CrsMatrix::Apply(), in double
   * precision, reads 108. Both are limited by the memory bandwidth alone.
   */
  class NodalMatrix : public Epetra_CrsMatrix
  {
  public:
    using Epetra_CrsMatrix::Epetra_CrsMatrix;

    /** Store the entries for multiply_roughly(), after FillComplete(). Every process has whole
     * blocks. */
    void
    finish(const unsigned int block_size);

    /** Compute Y = K X in single precision. */
    void
    multiply_roughly(const Epetra_Vector &X, Epetra_Vector &Y) const;

  private:
    template <unsigned int size>
    void
    multiply(const float *x, double *y) const;

    unsigned int size = 1;
    /** Position of every local column among the blocks. */
    std::vector<int> places;
    int n_block_columns = 0;
    /** Start of every row of blocks, and one more at the end. */
    std::vector<std::size_t> starts;
    /** First position of the columns of every block. */
    std::vector<int> first_places;
    /** Entries of the blocks, by columns. */
    std::vector<float> values;
  };
} // namespace fuga

#endif
