// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return the horizontal direction of an earthquake in space, as a unit vector; x if none is
     * given. */
    std::array<double, 2>
    read_horizontal_direction(const ParameterSection &section, const unsigned int dimension)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      const Text &entry    = e.horizontal_direction;
      if (!section.given(entry))
        return {{1., 0.}};
      if (dimension == 2)
        section.fail(entry,
                     "in the plane the only horizontal direction is x. Remove this entry; the sign "
                     "of 'Horizontal coefficient' says which way.");
      if (!section.given(e.horizontal_coefficient))
        section.fail(entry,
                     "a direction without 'Horizontal coefficient' does nothing. Add the "
                     "coefficient, or remove this entry.");
      const std::vector<std::string> pieces = split_pieces(section.text(entry), ';');
      const bool is_pair                    = pieces.size() == 2;
      const auto x                          = is_pair ? number_of_text(pieces[0]) : std::nullopt;
      const auto y                          = is_pair ? number_of_text(pieces[1]) : std::nullopt;
      if (!x || !y)
        section.fail(entry,
                     "a horizontal direction is two numbers 'x; y', for example '0; 1' for y.");
      const double length = std::hypot(*x, *y);
      if (length == 0.)
        section.fail(entry,
                     "this vector has no direction. Write one that is not 0, for example '0; 1' "
                     "for y; its length does not count.");
      return {{*x / length, *y / length}};
    }
  } // namespace


  std::vector<std::string>
  read_seismic_coefficients(const ParameterSection &section, const unsigned int dimension)
  {
    const LoadEntries &e   = entries_of<LoadEntries>();
    const auto coefficient = [&](const Number &entry) {
      return section.given(entry) ? section.text(entry) : std::string("0");
    };
    const auto acts = [&](const Number &entry) { return section.value_or(entry, 0.) != 0.; };
    if (!acts(e.horizontal_coefficient) && !acts(e.vertical_coefficient))
      section.fail("no coefficient is given, or all are 0, so that this load does nothing. Set "
                   "'Horizontal coefficient' or 'Vertical coefficient'.");
    const std::array<double, 2> direction = read_horizontal_direction(section, dimension);
    const std::string horizontal          = coefficient(e.horizontal_coefficient);
    std::vector<std::string> force_per_weight;
    for (unsigned int c = 0; c + 1 < dimension; ++c)
      force_per_weight.push_back(direction[c] == 1. ? horizontal
                                 : direction[c] == 0.
                                   ? "0"
                                   : fmt::format("({}) * ({:.17g})", horizontal, direction[c]));
    force_per_weight.push_back(coefficient(e.vertical_coefficient));
    return force_per_weight;
  }
} // namespace fuga
