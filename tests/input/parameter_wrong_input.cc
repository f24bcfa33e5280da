// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/base/errors.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

#include <cstdlib>
#include <iostream>

namespace fuga
{
  namespace testing_files
  {
    void
    PrintTo(const WrongInput &input, std::ostream *stream)
    {
      *stream << input.name;
    }


    std::string
    name_of(const testing::TestParamInfo<WrongInput> &info)
    {
      return info.param.name;
    }


    std::string
    message_of(const std::string &file, const Texts &overrides)
    {
      try
        {
          read_parameters(file, overrides);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      ADD_FAILURE() << "accepted: " << file;
      return "";
    }


    void
    expect_parts(const std::string &message, const Texts &parts)
    {
      for (const std::string &part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
          << "missing: " << part << "\nin:      " << message;
    }


    void
    expect_explained(const WrongInput &input)
    {
      const std::string file =
        write_file(input.name + ".prm", replaced(example_prm(), input.changes));
      const std::string message = message_of(file, input.overrides);
      expect_parts(message, input.message);
      if (std::getenv("FUGA_SHOW_MESSAGES") != nullptr)
        std::cout << message << std::endl;
    }
  } // namespace testing_files
} // namespace fuga
