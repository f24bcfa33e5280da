// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <fuga/bodies/solvers/nodal_matrix.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace fuga
{
  void
  NodalMatrix::finish(const unsigned int block_size)
  {
    size                     = block_size;
    const int b              = static_cast<int>(size);
    const Epetra_Map &column = ColMap();
    std::map<int, int> blocks_of_others;
    for (int c = NumMyRows(); c < column.NumMyElements(); ++c)
      blocks_of_others.emplace(column.GID(c) / b, 0);
    n_block_columns = NumMyRows() / b;
    for (auto &[block, number] : blocks_of_others)
      number = n_block_columns++;
    for (int c = 0; c < column.NumMyElements(); ++c)
      places.push_back(
        c < NumMyRows() ? c : blocks_of_others[column.GID(c) / b] * b + column.GID(c) % b);

    starts = {0};
    std::vector<int> blocks;
    for (int row = 0; row < NumMyRows(); row += b)
      {
        const auto for_each_entry = [&](const auto &action) {
          for (int i = 0; i < b; ++i)
            {
              int n, *indices;
              double *entries;
              ExtractMyRowView(row + i, n, entries, indices);
              for (int k = 0; k < n; ++k)
                action(i, places[static_cast<std::size_t>(indices[k])], entries[k]);
            }
        };
        blocks.clear();
        for_each_entry(
          [&](const int, const int place, const double) { blocks.push_back(place / b * b); });
        std::sort(blocks.begin(), blocks.end());
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        first_places.insert(first_places.end(), blocks.begin(), blocks.end());
        values.resize(first_places.size() * size * size);
        for_each_entry([&](const int i, const int place, const double entry) {
          const auto block =
            std::lower_bound(blocks.begin(), blocks.end(), place / b * b) - blocks.begin();
          values[(starts.back() + static_cast<std::size_t>(block)) * size * size +
                 static_cast<std::size_t>(place % b * b + i)] = static_cast<float>(entry);
        });
        starts.push_back(first_places.size());
      }
    values.resize(values.size() + 4, 0.F);
  }


  // Four numbers are read at a time, of which the first two or three belong to a column of a block.
  // The sums of single columns do not wait for each other.
  template <unsigned int b>
  void
  NodalMatrix::multiply(const float *x, double *y) const
  {
    typedef float Lanes __attribute__((vector_size(16)));
    const float *value = values.data();
    for (std::size_t row = 0; row + 1 < starts.size(); ++row)
      {
        Lanes sums[b] = {};
        for (std::size_t k = starts[row]; k < starts[row + 1]; ++k, value += b * b)
          for (unsigned int j = 0; j < b; ++j)
            {
              Lanes column;
              std::memcpy(&column, value + j * b, sizeof(column));
              sums[j] += column * x[first_places[k] + static_cast<int>(j)];
            }
        for (unsigned int j = 1; j < b; ++j)
          sums[0] += sums[j];
        for (unsigned int i = 0; i < b; ++i)
          y[row * b + i] = static_cast<double>(sums[0][i]);
      }
  }


  void
  NodalMatrix::multiply_roughly(const Epetra_Vector &X, Epetra_Vector &Y) const
  {
    std::vector<float> x(static_cast<std::size_t>(n_block_columns) * size, 0.F);
    const auto take = [&](const Epetra_Vector &columns) {
      for (std::size_t c = 0; c < places.size(); ++c)
        x[static_cast<std::size_t>(places[c])] = static_cast<float>(columns[static_cast<int>(c)]);
    };
    if (Importer() == nullptr)
      take(X);
    else
      {
        Epetra_Vector columns(ColMap(), false);
        columns.Import(X, *Importer(), Insert);
        take(columns);
      }
    size == 2 ? multiply<2>(x.data(), Y.Values()) : multiply<3>(x.data(), Y.Values());
  }
} // namespace fuga
