// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_nodal_matrix_h
#define fuga_bodies_solvers_nodal_matrix_h

#include <Epetra_CrsMatrix.h>

#include <vector>

namespace fuga
{
  /**
   * A matrix whose rows and columns come in blocks of one node each. Multigrid smooths with it, so
   * that Apply() multiplies in single precision and reads a place of a column once for a block:
   * 40 bytes for nine entries in space, where Epetra_CrsMatrix::Multiply(), in double precision,
   * reads 108. Both wait for the memory alone.
   */
  class NodalMatrix : public Epetra_CrsMatrix
  {
  public:
    using Epetra_CrsMatrix::Epetra_CrsMatrix;

    /** After FillComplete(): takes the entries for Apply(). Every process has whole blocks. */
    void
    finish(const unsigned int block_size);

    /** Y = K X to single precision. */
    int
    Apply(const Epetra_MultiVector &X, Epetra_MultiVector &Y) const override;

  private:
    template <unsigned int size>
    void
    multiply(const float *x, double *y) const;

    unsigned int size = 1;
    /** Of every local column its place among the blocks. */
    std::vector<int> places;
    int n_block_columns = 0;
    /** Of every row of blocks; one more at the end. */
    std::vector<std::size_t> starts;
    /** Of every block the first place of its columns. */
    std::vector<int> first_places;
    /** Blocks by columns. */
    std::vector<float> values;
  };
} // namespace fuga

#endif
