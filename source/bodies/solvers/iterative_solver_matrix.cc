// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/mpi.h>

#include <fuga/bodies/solvers/iterative_system.h>

#include <algorithm>
#include <map>

namespace fuga
{
  namespace
  {
    /** A value for the process that owns its row, in K_ii or, in the columns after it, in K_ic. */
    struct Contribution
    {
      int row, column;
      double value;

      /** Serialize the object for deal.II, which sends it. */
      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &row &column &value;
      }
    };

    using Contributions = std::vector<Contribution>;


    /** Call @p eliminated(row, column, value) for the entries of K_ii, of both triangles, and of
     * K_ic, and @p kept(row, column, value) for those of K_cc. */
    template <typename Eliminated, typename Kept>
    void
    for_each_entry(const SymmetricTriplets &matrix,
                   const NodalBlocks &blocks,
                   const Eliminated &eliminated,
                   const Kept &kept)
    {
      const auto n_eliminated = static_cast<int>(blocks.rows.size());
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        {
          const double value = matrix.values[k];
          const auto [a, b]  = std::minmax({matrix.rows[k] - 1, matrix.columns[k] - 1});
          if (a >= n_eliminated)
            {
              kept(b - n_eliminated, a - n_eliminated, value);
              continue;
            }
          const int row = blocks.rows[static_cast<std::size_t>(a)];
          if (b >= n_eliminated)
            {
              eliminated(row, blocks.n_rows() + b - n_eliminated, value);
              continue;
            }
          const int column = blocks.rows[static_cast<std::size_t>(b)];
          eliminated(row, column, value);
          if (a != b)
            eliminated(column, row, value);
        }
    }


    /** Return the contributions of the cells of other processes to the rows of this process. */
    Contributions
    exchange(const SymmetricTriplets &matrix, const NodalBlocks &blocks, const MPI_Comm comm)
    {
      Contributions result;
      if (processes::number() == 1)
        return result;
      std::map<unsigned int, Contributions> to_others;
      for_each_entry(
        matrix,
        blocks,
        [&](const int row, const int column, const double value) {
          const auto &first = blocks.first_rows;
          const auto owner  = static_cast<unsigned int>(
            std::upper_bound(first.begin(), first.end(), row) - first.begin() - 1);
          if (owner != processes::rank())
            to_others[owner].push_back({row, column, value});
        },
        [](const int, const int, const double) {});
      processes::meet(processes::Place::solver);
      for (const auto &[sender, part] : dealii::Utilities::MPI::some_to_some(comm, to_others))
        result.insert(result.end(), part.begin(), part.end());
      return result;
    }


    /** Number columns as Trilinos does: first the rows of this process, then those of others. */
    Epetra_Map
    map_of_columns(const Epetra_Map &map, Compressed &rows)
    {
      if (processes::number() == 1)
        return map;
      std::vector<int> columns(static_cast<std::size_t>(map.NumMyElements())), others;
      map.MyGlobalElements(columns.data());
      for (const int column : rows.indices)
        if (!map.MyGID(column))
          others.push_back(column);
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
      for (int &column : rows.indices)
        column = map.MyGID(column)
                   ? map.LID(column)
                   : map.NumMyElements() +
                       static_cast<int>(std::lower_bound(others.begin(), others.end(), column) -
                                        others.begin());
      columns.insert(columns.end(), others.begin(), others.end());
      return {-1, static_cast<int>(columns.size()), columns.data(), 0, map.Comm()};
    }


    /** Return a Trilinos matrix from rows in which indices, of @p columns, may repeat; rows without
     * entries get @p diagonal. */
    std::unique_ptr<NodalMatrix>
    epetra_matrix(const Epetra_Map &map,
                  const Epetra_Map &columns,
                  const Compressed &rows,
                  const double diagonal)
    {
      const int n_rows = map.NumMyElements();
      std::vector<int> counts(static_cast<std::size_t>(n_rows), 1);
      std::vector<std::pair<int, double>> entries;
      const auto read_row = [&](const std::size_t row) {
        entries.clear();
        for (std::size_t k = rows.start[row]; k < rows.start[row + 1]; ++k)
          entries.emplace_back(rows.indices[k], rows.values[k]);
        std::sort(entries.begin(), entries.end(), [](const auto &a, const auto &b) {
          return a.first < b.first;
        });
        std::size_t last = 0;
        for (std::size_t k = 1; k < entries.size(); ++k)
          if (entries[k].first == entries[last].first)
            entries[last].second += entries[k].second;
          else
            entries[++last] = entries[k];
        if (entries.empty())
          entries.emplace_back(static_cast<int>(row), diagonal);
        else
          entries.resize(last + 1);
      };
      for (std::size_t row = 0; row < counts.size(); ++row)
        {
          read_row(row);
          counts[row] = static_cast<int>(entries.size());
        }
      auto matrix = std::make_unique<NodalMatrix>(Copy, map, columns, counts.data(), true);
      std::vector<int> indices;
      std::vector<double> values;
      for (std::size_t row = 0; row < counts.size(); ++row)
        {
          read_row(row);
          indices.clear();
          values.clear();
          for (const auto &[index, value] : entries)
            {
              indices.push_back(index);
              values.push_back(value);
            }
          matrix->InsertMyValues(static_cast<int>(row), counts[row], values.data(), indices.data());
        }
      matrix->FillComplete(map, map);
      matrix->OptimizeStorage();
      return matrix;
    }
  } // namespace


  // The triplets are released before the matrix of Trilinos is created, so that there are never
  // three copies.
  void
  IterativeSolver::split(SymmetricTriplets &matrix)
  {
    const Contributions of_others = exchange(matrix, blocks, system->comm.Comm());
    const int n_own = blocks.n_own_rows(), n_rows = blocks.n_rows();
    Compressed interior(n_own_rows());
    double sum_of_diagonal = 0.;
    for (const bool counting : {true, false})
      {
        if (!counting)
          {
            interior.finish_counting();
            system->coupling.finish_counting();
            system->kept.finish_counting();
          }
        const auto put =
          [counting](Compressed &to, const int row, const int index, const double value) {
            if (counting)
              to.count(static_cast<std::size_t>(row));
            else
              to.add(static_cast<std::size_t>(row), index, value);
          };
        const auto put_eliminated = [&](const int row, const int column, const double value) {
          const int place = blocks.own_place(row);
          if (place < 0 || place >= n_own)
            return;
          if (column >= n_rows)
            put(system->coupling, column - n_rows, place, value);
          else
            put(interior, place, column, value);
          if (row == column && counting)
            sum_of_diagonal += value;
        };
        for_each_entry(
          matrix, blocks, put_eliminated, [&](const int row, const int column, const double value) {
            put(system->kept, row, column, value);
          });
        for (const Contribution &of_one : of_others)
          put_eliminated(of_one.row, of_one.column, of_one.value);
      }
    matrix = {};
    processes::sum(&sum_of_diagonal, 1);
    const Epetra_Map columns = map_of_columns(system->map, interior);
    system->K =
      epetra_matrix(system->map, columns, interior, sum_of_diagonal / std::max(1, n_rows));
    system->K->finish(blocks.block_size);
  }
} // namespace fuga
