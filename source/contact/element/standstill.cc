// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/standstill.h>

#include <algorithm>

namespace fuga
{
  void
  Standstill::forget()
  {
    if (steps > 0)
      *this = Standstill();
  }

  std::vector<BoundaryElement>
  Standstill::unite(std::vector<BoundaryElement> set)
  {
    if (steps == 0)
      {
        known = set;
        return set;
      }
    const std::size_t n_known = known.size();
    for (const BoundaryElement &candidate : set)
      {
        const auto same = std::find_if(known.begin(), known.end(), [&](const BoundaryElement &old) {
          return old.element == candidate.element;
        });
        if (same == known.end())
          known.push_back(candidate);
        else
          *same = candidate;
      }
    if (known.size() > n_known)
      {
        schemes.clear();
        std::sort(known.begin(), known.end(), [](const auto &a, const auto &b) {
          return a.element < b.element;
        });
      }
    return known;
  }

  bool
  Standstill::note(const std::vector<ContactState> &scheme)
  {
    ++steps;
    const bool is_new = schemes.insert(scheme).second;
    repetitions += is_new ? 0 : 1;
    return is_new;
  }
} // namespace fuga
