// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_scheme_memory_h
#define fuga_contact_scheme_scheme_memory_h

#include <fuga/base/fields.h>
#include <fuga/contact/element/scheme_row.h>

namespace fuga
{
  /** A row of the active matrix that was removed (given by its number) or, if `removed` is none,
   * appended. */
  struct RowExchange
  {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t removed = none;
    SchemeRow appended;
  };

  /**
   * Everything that the next solution of a working scheme depends on. The last bits of the updated
   * inverse depend on its history. The inverse itself is not stored: it is reproduced bit for bit
   * from the matrix that was last factorised and the rows exchanged since, repeated in their order.
   */
  struct SchemeMemory
  {
    bool outdated = true;
    bool singular = false;
    /** True if the inverse belongs to an earlier stiffness of nonlinear layers. */
    bool stale = false;
    std::vector<ContactState> states;
    /** Directions of slip, in space. */
    std::vector<TangentVector> directions;
    std::vector<Strength> strengths;
    /** Tangents of the layers, by element; empty if no layer and no strength is nonlinear. */
    std::vector<LayerTangent> tangents;
    /** Slopes of the strength at the present pressures in units of f, likewise. */
    Vector slopes;
    std::vector<SchemeRow> rows;
    /** Rows of the matrix that was factorised, the capacity of its inverse, and the exchanges that
     * followed. */
    std::vector<SchemeRow> factorised_rows;
    std::size_t capacity = 0;
    std::vector<RowExchange> exchanges;
  };

  template <typename Memory, typename Visitor, only_for<Memory, SchemeMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[outdated,
           singular,
           stale,
           states,
           directions,
           strengths,
           tangents,
           slopes,
           rows,
           factorised_rows,
           capacity,
           exchanges] = memory;
    visit("outdated", outdated);
    visit("singular", singular);
    visit("stale", stale);
    visit("states", states);
    visit("directions", directions);
    visit("strengths", strengths);
    visit("tangents", tangents);
    visit("slopes", slopes);
    visit("rows", rows);
    visit("factorised_rows", factorised_rows);
    visit("capacity", capacity);
    visit("exchanges", exchanges);
  }
} // namespace fuga

#endif
