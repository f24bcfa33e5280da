// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/solvers/iterative_system.h>

namespace fuga
{
  void
  add_column(const Compressed &coupling, const double factor, const std::size_t i, double *y)
  {
    for (std::size_t k = coupling.start[i]; k < coupling.start[i + 1]; ++k)
      y[coupling.indices[k]] += factor * coupling.values[k];
  }


  void
  add_to_interior(const Compressed &coupling, const double factor, const double *x, double *y)
  {
    for (std::size_t i = 0; i + 1 < coupling.start.size(); ++i)
      add_column(coupling, factor * x[i], i, y);
  }


  void
  add_to_kept(const Compressed &coupling, const double factor, const double *x, double *y)
  {
    for (std::size_t i = 0; i + 1 < coupling.start.size(); ++i)
      for (std::size_t k = coupling.start[i]; k < coupling.start[i + 1]; ++k)
        y[i] += factor * coupling.values[k] * x[coupling.indices[k]];
  }


  void
  add_kept_block(const Compressed &kept, const double *x, double *y)
  {
    for_each_kept_entry(kept, [&](const std::size_t i, const std::size_t j, const double value) {
      y[i] += value * x[j];
    });
  }
} // namespace fuga
