// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_imposed_gap_h
#define fuga_bodies_loads_imposed_gap_h

#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/loads/load_assembly.h>

namespace fuga
{
  /**
   * Return the imposed jumps of all bars [m] for a load of kind imposed_gap: its value at the
   * elements of its joints, in their normal bars.
   * @throws InputError if the expression has no value there.
   */
  template <int dim>
  Vector
  imposed_gap(const LoadDefinition &load,
              const std::map<std::string, double> &constants,
              const double t,
              const JointedMesh &mesh,
              const ContactBars<dim> &bars);

  /** Return E of doc/theory.md, eq. 2a: a column per pattern; empty if none imposes jumps. */
  DenseMatrix
  imposed_jumps_of(const std::vector<LoadPattern> &patterns, const std::size_t n_bars);
} // namespace fuga

#endif
