// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_io_parameter_wrong_input_h
#define fuga_tests_io_parameter_wrong_input_h

#include "parameter_test_files.h"

#include <gtest/gtest.h>

#include <iosfwd>

namespace fuga
{
  namespace testing_files
  {
    using Changes = std::vector<std::pair<std::string, std::string>>;
    using Texts   = std::vector<std::string>;

    /** Something wrong with the example file, and what the message must contain. */
    struct WrongInput
    {
      std::string name;
      Changes changes;
      Texts overrides;
      Texts message;
    };

    /** For readable names in the output of the tests. */
    void
    PrintTo(const WrongInput &input, std::ostream *stream);

    std::string
    name_of(const testing::TestParamInfo<WrongInput> &info);

    /** The message of the InputError that reading the file throws; fails if it throws none. */
    std::string
    message_of(const std::string &file, const Texts &overrides = {});

    void
    expect_parts(const std::string &message, const Texts &parts);

    /** Reads the example with the error in it, and looks at the message. FUGA_SHOW_MESSAGES in the
     *  environment prints it. */
    void
    expect_explained(const WrongInput &input);
  } // namespace testing_files
} // namespace fuga

#endif
