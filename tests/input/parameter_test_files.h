// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_io_parameter_test_files_h
#define fuga_tests_io_parameter_test_files_h

#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  namespace testing_files
  {
    /** Writes into the folder of temporary files (and "example.msh" beside it); the full name. */
    std::string
    write_file(const std::string &name, const std::string &text);

    /** A valid parameter file that uses most entries; its mesh is "example.msh". */
    const std::string &
    example_prm();

    /** Replaces the first occurrence of each first text by the second; fails if there is none. */
    std::string
    replaced(std::string text, const std::vector<std::pair<std::string, std::string>> &changes);
  } // namespace testing_files
} // namespace fuga

#endif
