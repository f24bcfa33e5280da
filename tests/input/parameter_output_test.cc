// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

namespace fuga
{
  namespace
  {
    using testing_files::Changes;
    using testing_files::example_prm;
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::replaced;
    using testing_files::Texts;
    using testing_files::write_file;
    using testing_files::WrongInput;

    /** The example with a second stage in which inertia acts. */
    Texts
    in_motion_with(const Texts &more)
    {
      Texts all = {"Stages/weight/Loads=weight: t; settlement: t",
                   "Stages/push/Loads=push: t; crane: t",
                   "Stages/push/Duration=2",
                   "Dynamics/Time step=0.01"};
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }

    const std::string spectra = "Output/Response spectra=true";
    const Changes unchanged, monitored = {{"subsection Output",
                                           "subsection Monitors\n  subsection top\n    set Point = "
                                           "0, 1\n  end\nend\nsubsection Output"}};

    OutputSettings
    read(const Texts &settings)
    {
      return read_parameters(write_file("output.prm", replaced(example_prm(), monitored)),
                             in_motion_with(settings))
        .output;
    }

    TEST(ParameterOutput, OfMotionsIsRead)
    {
      EXPECT_FALSE(read({}).spectra.wanted);
      EXPECT_EQ(read({}).field_interval, 0.);
      EXPECT_EQ(read({"Output/Field interval=0.1"}).field_interval, 0.1);
      const SpectrumSettings usual = read({spectra}).spectra;
      EXPECT_TRUE(usual.wanted);
      EXPECT_EQ(usual.damping, 0.05);
      ASSERT_EQ(usual.periods.size(), 100u);
      EXPECT_DOUBLE_EQ(usual.periods.front(), 0.02);
      EXPECT_DOUBLE_EQ(usual.periods.back(), 5.);
      const SpectrumSettings chosen =
        read({spectra, "Output/Spectrum damping=0", "Output/Spectrum periods=0.1, 2*3"}).spectra;
      EXPECT_EQ(chosen.damping, 0.);
      EXPECT_EQ(chosen.periods, (std::vector<double>{0.1, 6.}));
    }

    class WrongOutput : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongOutput, IsExplained)
    {
      expect_explained(GetParam());
    }

    const WrongInput wrong[] = {
      {"SpectraWithoutDuration",
       monitored,
       {spectra},
       {"Response spectra = 'true'", "no stage has a Duration"}},
      {"SpectraWithoutMonitors",
       unchanged,
       in_motion_with({spectra}),
       {"Response spectra = 'true'", "no monitors"}},
      {"PeriodsWithoutSpectra",
       unchanged,
       in_motion_with({"Output/Spectrum periods=1"}),
       {"Spectrum periods = '1'", "'Response spectra = true'"}},
      {"CriticalDamping",
       monitored,
       in_motion_with({spectra, "Output/Spectrum damping=1"}),
       {"Spectrum damping = '1'", ">= 0 and < 1"}},
      {"PeriodOfZero",
       monitored,
       in_motion_with({spectra, "Output/Spectrum periods=1, 0"}),
       {"Spectrum periods = '1, 0'", "not a list of periods above 0", "'0.1, 0.2, 0.5'"}},
      {"IntervalWithoutMotion",
       unchanged,
       {"Output/Field interval=0.1"},
       {"Field interval = '0.1'", "nothing moves"}}};

    INSTANTIATE_TEST_SUITE_P(Output, WrongOutput, testing::ValuesIn(wrong), name_of);
  } // namespace
} // namespace fuga
