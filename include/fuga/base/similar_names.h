// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_similar_names_h
#define fuga_base_similar_names_h

#include <string>
#include <vector>

namespace fuga
{
  /**
   * Return "Did you mean 'a' or 'b'?", preceded by @p before, with the names among @p known that
   * are a few letters away from @p wrong, ignoring case; "" if there are none.
   */
  std::string
  did_you_mean(const std::string &wrong,
               const std::vector<std::string> &known,
               const std::string &before = "");
} // namespace fuga

#endif
