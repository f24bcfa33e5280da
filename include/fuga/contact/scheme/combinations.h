// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_combinations_h
#define fuga_contact_scheme_combinations_h

#include <cstddef>
#include <vector>

namespace fuga
{
  /** Largest number of combinations of states that are tried: 4 states of six elements, 2 of
   * twelve. */
  constexpr double most_combinations = 4096.;

  /** Return the number of combinations of one choice for every element, where @p choices lists
   * those of each element. */
  template <typename Choice>
  double
  n_combinations(const std::vector<std::vector<Choice>> &choices)
  {
    double n = 1.;
    for (const std::vector<Choice> &of_element : choices)
      n *= static_cast<double>(of_element.size());
    return n;
  }

  /** Call @p visit with the numbers of the choices of every combination, those of the first element
   * running fastest, until it returns true. Return whether it did. */
  template <typename Choice, typename Visit>
  bool
  any_combination(const std::vector<std::vector<Choice>> &choices, const Visit &visit)
  {
    std::vector<std::size_t> chosen(choices.size(), 0);
    while (true)
      {
        if (visit(chosen))
          return true;
        std::size_t i = 0;
        while (i < choices.size() && ++chosen[i] == choices[i].size())
          chosen[i++] = 0;
        if (i == choices.size())
          return false;
      }
  }
} // namespace fuga

#endif
