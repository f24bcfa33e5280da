// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_known_answer_h
#define fuga_tests_known_answer_h

#include <nlohmann/json.hpp>

#include <string>

namespace fuga::tests
{
  /** A number that is known from somewhere else than the program. */
  struct KnownAnswer
  {
    /** The verification problem, such as "V5 pull-out". */
    std::string problem;
    /** What it is, with its unit if it has one. */
    std::string quantity;
    double value = 0.;
    /** Where it comes from: a closed form, a publication, an independent solver. */
    std::string source;
  };

  /**
   * Expects @p ours within @p tolerance of the known answer. If the environment variable
   * FUGA_VERIFICATION names a file, appends both to it as one line of JSON: the rows of
   * doc/verification.md (tools/verification_page.py).
   */
  void
  expect_answer(const KnownAnswer &known, const double ours, const double tolerance);

  /** The source of the answers below, for KnownAnswer::source. */
  constexpr const char *independent_code = "independent code";

  /**
   * What tests/scenes/reference/independent.py has computed: a code of its own, which anyone can
   * run (ctest -R independent does). Its README says how, and how many digits are kept.
   */
  const nlohmann::json &
  independent_answers();
} // namespace fuga::tests

#endif
