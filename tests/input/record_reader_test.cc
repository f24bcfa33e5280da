// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/base/errors.h>
#include <fuga/input/dynamics/record_reader.h>

#include <cmath>
#include <fmt/format.h>
#include <random>

namespace fuga
{
  namespace
  {
    const std::string at2 =
      "PEER STRONG MOTION DATABASE RECORD\n"
      "A VALLEY 01/02/1990, A STATION, 090\n"
      "ACCELERATION TIME SERIES IN UNITS OF G\n"
      "NPTS=    7, DT=   .0050 SEC\n"
      "   .1000000E-02   .2000000E-02  -.3000000E-02   .4000000E-02   .5E-02\n"
      "  -.6000000E-02   .7000000E-02\n";
    const Vector samples = {1e-3, 2e-3, -3e-3, 4e-3, 5e-3, -6e-3, 7e-3};

    TEST(RecordReader, ReadsTheFormOfPeer)
    {
      const GroundMotion motion = read_record_at2("a.at2", at2);
      EXPECT_EQ(motion.step, 0.005);
      EXPECT_EQ(motion.accelerations, samples);
      const std::string older = testing_files::replaced(
        at2, {{"NPTS=    7, DT=   .0050 SEC", "    7    .0050    NPTS, DT"}});
      EXPECT_EQ(read_record_at2("a.at2", older).step, 0.005);
      EXPECT_EQ(read_record_at2("a.at2", older).accelerations, samples);
    }

    TEST(RecordReader, ReadsColumns)
    {
      const GroundMotion motion = read_record_in_columns("a.txt",
                                                         "# time, a\r\n\n0.0, 0.5\r\n"
                                                         "0.1, -1e-1 # peak\r\n 0.2,+3\r\n",
                                                         {});
      EXPECT_NEAR(motion.step, 0.1, 1e-16);
      EXPECT_EQ(motion.accelerations, (Vector{0.5, -0.1, 3.}));
      // No column of times; another one; a last line without end.
      const GroundMotion other = read_record_in_columns("a.txt", "7;1;2\n8;3;4", {0, 0.02, 3});
      EXPECT_EQ(other.step, 0.02);
      EXPECT_EQ(other.accelerations, (Vector{2., 4.}));
      EXPECT_EQ(read_record_in_columns("a.txt", "1 4\n2 5\n3 6\n", {2, 0., 1}).accelerations.size(),
                3u);
    }

    // 1/128 s with four digits: the times are off by up to 5e-5 s, the step of them all is not.
    TEST(RecordReader, TimesMayBeRounded)
    {
      std::string text;
      for (int i = 0; i <= 1000; ++i)
        text += fmt::format("{:.4f} {}\n", i / 128., i % 7);
      EXPECT_NEAR(read_record_in_columns("a.txt", text, {}).step, 1. / 128., 1e-7);
    }

    struct WrongRecord
    {
      std::string name;
      std::string text;
      std::vector<std::string> message;
      RecordColumns columns = {};
    };

    void
    PrintTo(const WrongRecord &record, std::ostream *stream)
    {
      *stream << record.name;
    }

    GroundMotion
    read(const std::string &name, const std::string &text, const RecordColumns &columns)
    {
      return name.rfind("At2", 0) == 0 ? read_record_at2("file", text)
                                       : read_record_in_columns("file", text, columns);
    }

    class WrongRecords : public testing::TestWithParam<WrongRecord>
    {
    };

    TEST_P(WrongRecords, AreExplained)
    {
      try
        {
          read(GetParam().name, GetParam().text, GetParam().columns);
          ADD_FAILURE() << "accepted";
        }
      catch (const InputError &error)
        {
          testing_files::expect_parts(error.what(), GetParam().message);
        }
    }

    std::string
    changed(const std::string &from, const std::string &to)
    {
      return testing_files::replaced(at2, {{from, to}});
    }

    const WrongRecord wrong[] = {
      {"Empty", "", {"file:1:", "0 samples", "right file"}},
      {"CommentsOnly", "# 1 2\n# 3 4\n", {"file:2:", "0 samples"}},
      {"OneSample", "0 1\n", {"1 samples"}},
      {"Words", "0 1\n0.1 big\n", {"file:2:", "'big' is not a number"}},
      {"NotFinite", "0 1\n0.1 nan\n", {"file:2:", "'nan'"}},
      {"Infinite", "0 1\n0.1 1e999\n", {"file:2:", "'1e999'"}},
      {"Huge", "0 1\n0.1 1e200\n", {"file:2:", "'1e200'", "at most 1e+15"}},
      {"MissingColumn", "1\n2\n", {"file:1:", "1 column", "Time column = 0"}},
      {"ColumnBehindTheLast",
       "0 1\n1 2\n",
       {"file:1:", "2 column", "Acceleration column' 7"},
       {1, 0., 7}},
      {"ShortLine", "0 1 2\n1 2\n", {"file:2:", "2 columns, those before have 3"}},
      {"MissingLine",
       "0 1\n0.1 2\n0.2 3\n0.4 5\n0.5 6\n0.6 7\n",
       {"file:4:", "0.2 s, but most are 0.1 s", "line missing"}},
      {"TimesFallBack", "0 1\n0.2 2\n0.1 3\n", {"file:3:", "0.1 comes after 0.2", "increase"}},
      {"DecimalCommas", "0,01 0,5\n0,02 0,6\n", {"file:2:", "decimal sign"}},
      {"At2Columns", "0 1\n1 2\n", {"no line with NPTS", "Record format"}},
      {"At2Empty", "", {"file:1:", "no line with NPTS"}},
      {"At2Velocity", changed("ACCELERATION", "VELOCITY"), {"file:3:", "record of the VELOCITY"}},
      {"At2CutOff", changed("   .7000000E-02", ""), {"6 samples, but says NPTS = 7"}},
      {"At2NoStep", changed(".0050", "0.00"), {"file:4:", "step [s] > 0"}},
      {"At2NumbersJoined", changed("   .2000000E-02", ".2E-02"), {"file:5:", "not a number"}},
      {"At2NotFinite", changed("-.6000000E-02", "NaN"), {"file:6:", "'NaN'"}}};

    std::string
    name_of_record(const testing::TestParamInfo<WrongRecord> &record)
    {
      return record.param.name;
    }

    INSTANTIATE_TEST_SUITE_P(Records, WrongRecords, testing::ValuesIn(wrong), name_of_record);

    // Spoilt texts are read or refused with the name of the file; what is read is finite.
    TEST(RecordReader, SpoiltTextsAreReadOrRefused)
    {
      const std::string letters = "0123456789+-.eE,;# \n\r\tNPTSD=\xff\0x";
      std::mt19937 random(1);
      const auto below = [&random](const std::size_t n) { return random() % n; };
      for (unsigned int i = 0; i < 20000; ++i)
        {
          std::string text = i % 2 == 0 ? at2 : "# t a\n0 1\n0.1 2\n0.2 3\n0.3 -4\n";
          for (std::size_t n = 1 + below(4); n > 0 && !text.empty(); --n)
            {
              const std::size_t at = below(text.size());
              if (const std::size_t way = below(4); way == 0)
                text[at] = letters[below(letters.size())];
              else if (way == 1)
                text.insert(at, 1 + below(300), letters[below(letters.size())]);
              else if (way == 2)
                text.erase(at, below(40));
              else
                text.insert(at, text.substr(below(text.size()), below(60)));
            }
          try
            {
              const GroundMotion motion = read(i % 4 < 2 ? "At2" : "Columns", text, {});
              EXPECT_GT(motion.step, 0.);
              EXPECT_GE(motion.accelerations.size(), 2u);
              for (const double a : motion.accelerations)
                EXPECT_TRUE(std::isfinite(a));
            }
          catch (const InputError &error)
            {
              EXPECT_EQ(std::string(error.what()).rfind("file:", 0), 0u) << error.what();
            }
        }
    }
  } // namespace
} // namespace fuga
