// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace fuga::tests
{
  void
  expect_answer(const KnownAnswer &known, const double ours, const double tolerance)
  {
    EXPECT_NEAR(ours, known.value, tolerance) << known.problem << ", " << known.quantity;
    const char *file = std::getenv("FUGA_VERIFICATION");
    if (file == nullptr)
      return;
    const testing::TestInfo *test    = testing::UnitTest::GetInstance()->current_test_info();
    const nlohmann::ordered_json row = {
      {"problem", known.problem},
      {"quantity", known.quantity},
      {"known", known.value},
      {"source", known.source},
      {"ours", ours},
      {"tolerance", tolerance},
      {"test", std::string(test->test_suite_name()) + "." + test->name()}};
    std::ofstream(file, std::ios::app) << row << '\n';
  }

  const nlohmann::json &
  independent_answers()
  {
    static const nlohmann::json answers = nlohmann::json::parse(
      std::ifstream(FUGA_SOURCE_DIR "/tests/scenes/reference/independent.json"));
    return answers;
  }
} // namespace fuga::tests
