// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_table_range_h
#define fuga_run_simulation_table_range_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

#include <string>
#include <vector>

namespace fuga
{
  /** Watches whether a run leaves the data of tabular laws; costs nothing where there are none. */
  class TableRange
  {
  public:
    explicit TableRange(const std::vector<ContactElement> &elements);

    void
    watch(const JointState &state);

    /** One sentence per joint and direction that went beyond its table. */
    template <int dim>
    std::vector<std::string>
    warnings(const std::vector<std::string> &joint_names, const std::string &stress_unit) const;

  private:
    /** A bar whose law has data up to a stress only, and the largest stress seen beyond. */
    struct Bar
    {
      std::size_t element;
      bool normal;
      double data_end;
      double largest;
      double t;
    };

    const std::vector<ContactElement> &elements;
    std::vector<Bar> bars;
  };
} // namespace fuga

#endif
