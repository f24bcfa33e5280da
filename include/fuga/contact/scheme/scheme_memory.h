// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_scheme_memory_h
#define fuga_contact_scheme_scheme_memory_h

#include <fuga/base/fields.h>
#include <fuga/contact/element/scheme_row.h>

namespace fuga
{
  /** A row of the active matrix that was removed (by its number) or, if `removed` is none,
   * appended. */
  struct RowExchange
  {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t removed = none;
    SchemeRow appended;
  };

  /**
   * All that the next solution of a working scheme depends on. The last bits of the updated inverse
   * depend on its history. It is not kept itself: the matrix it was last factorised from and the
   * rows exchanged since, repeated in their order, give it again bit for bit.
   */
  struct SchemeMemory
  {
    bool outdated = true;
    bool singular = false;
    /** The inverse belongs to an earlier stiffness of nonlinear layers. */
    bool stale = false;
    std::vector<ContactState> states;
    /** Of slip, in space. */
    std::vector<TangentVector> directions;
    std::vector<Strength> strengths;
    /** By element; empty if no layer is nonlinear. */
    std::vector<LayerTangent> tangents;
    std::vector<SchemeRow> rows;
    /** Rows of the matrix that was factorised, capacity of its inverse, and what followed. */
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
    visit("rows", rows);
    visit("factorised_rows", factorised_rows);
    visit("capacity", capacity);
    visit("exchanges", exchanges);
  }
} // namespace fuga

#endif
