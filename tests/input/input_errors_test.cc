// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_test_files.h"
#include "parameter_wrong_input.h"

#include <gtest/gtest.h>

namespace fuga
{
  namespace
  {
    using namespace testing_files;

    std::size_t
    count(const std::string &text, const std::string &part)
    {
      std::size_t n = 0;
      for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
      return n;
    }

    /** The parts stand in the message one after the other. */
    void
    expect_in_order(const std::string &message, const Texts &parts)
    {
      std::size_t at = 0;
      for (const std::string &part : parts)
        {
          const std::size_t next = message.find(part, at);
          ASSERT_NE(next, std::string::npos)
            << "missing or too early: " << part << "\nin: " << message;
          at = next + part.size();
        }
    }

    // One of every kind: of the format of a number, of a reference, of a missing entry; the order
    // is that of the lines, not the one in which they are found.
    TEST(InputErrors, AllOfAFileInItsOrder)
    {
      const std::string file =
        write_file("several.prm",
                   replaced(example_prm(),
                            {{"= 3060\n", "= -3060\n"},
                             {"set Minus body = rock", "set Minus body = rok"},
                             {"set Fixed = x\n", "set Fixed = w\n"},
                             {"    set Type = weight\n", ""},
                             {"settlement: t^2", "setlement: t^2"}}));
      const std::string message = message_of(file);
      expect_in_order(message,
                      {".prm:13: Bodies/dam/Young modulus = '-3060': this is out of range",
                       "\nError: ",
                       "Boundaries/sides/Fixed = 'w'",
                       "\nError: ",
                       "Loads/weight/Type is missing",
                       "\nError: ",
                       "there is no load 'setlement'",
                       "Did you mean 'settlement'?",
                       "\n4 errors. Nothing was computed."});
      // Joints name bodies, of which one is wrong already: not looked at before that is corrected.
      EXPECT_EQ(message.find("rok"), std::string::npos) << message;
    }

    // A wrong body is one error, however many joints, loads and monitors depend on it.
    TEST(InputErrors, NoneFollowsFromAnother)
    {
      for (const Changes &changes :
           {Changes{{"set Weight density = 0.024", "set Weight density = heavy"}},
            Changes{{"set Weight densi", "set Weigth densi"}},
            Changes{{"set q = 0.0144", "set q = 2*"}},
            Changes{{"    set Loads = push: t; crane", "    set Loads = crane"},
                    {"sin(pi*t/2)", "sin(pi*u/2)"}},
            Changes{{"set Type = point force", "set Type = pointed"}},
            Changes{{"subsection Bodies", "subsection Bodeis"}},
            Changes{{"set Fixed = x, y", "set Fixed = x, q"}}})
        {
          const std::string message =
            message_of(write_file("follow.prm", replaced(example_prm(), changes)));
          EXPECT_EQ(count(message, "Error: "), 0u) << message;
          EXPECT_EQ(message.find("Nothing was computed"), std::string::npos) << message;
        }
    }

    TEST(InputErrors, TwentyAreShown)
    {
      std::string bodies;
      for (int i = 0; i < 25; ++i)
        bodies += "  subsection body" + std::to_string(i) +
                  "\n    set Young modulus = 0\n    set Poisson ratio = 0.2\n  end\n";
      const std::string message = message_of(write_file(
        "twenty.prm",
        replaced(example_prm(), {{"  subsection rock\n", bodies + "  subsection rock\n"}})));
      EXPECT_EQ(count(message, "this is out of range"), 20u);
      expect_in_order(message, {"body0/", "body19/", "25 errors, the first 20 are shown."});
      EXPECT_EQ(message.find("body20/"), std::string::npos);
    }

    // Explanations of entries name units of MN and m unless the user named others.
    TEST(InputErrors, UnitsOfTheUser)
    {
      const Changes wrong = {{"= 3060\n", "= -3060\n"},
                             {"set Weight density = 0.024", "set Weight density = -1"}};
      expect_in_order(message_of(write_file("units_default.prm", replaced(example_prm(), wrong))),
                      {"E of the body [MPa].", "Weight per volume [MN/m^3]"});
      expect_in_order(message_of(write_file("units_kn.prm", replaced(example_prm(), wrong)),
                                 {"Output/Force unit=kN", "Output/Length unit=cm"}),
                      {"E of the body [kN/cm2].", "Weight per volume [kN/cm^3]"});
    }
  } // namespace
} // namespace fuga
