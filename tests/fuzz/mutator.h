// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_fuzz_mutator_h
#define fuga_tests_fuzz_mutator_h

#include "campaign/random.h"

#include <string>
#include <vector>

namespace fuga::fuzz
{
  /**
   * Spoils a text in one of many ways: bytes, numbers, words, lines, blocks of lines, its end, its
   * depth of nesting. @p others: texts from which foreign lines are taken.
   */
  std::string
  mutate(const std::string &text, campaign::Random &random, const std::vector<std::string> &others);
} // namespace fuga::fuzz

#endif
