// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/read/parameter_readers.h>
#include <fuga/input/values/value_readers.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Return periods in equal ratios, as they are plotted. */
    std::vector<double>
    usual_periods()
    {
      constexpr double first = 0.02, last = 5.;
      constexpr int n = 100;
      std::vector<double> periods;
      for (int i = 0; i < n; ++i)
        periods.push_back(first * std::pow(last / first, i / (n - 1.)));
      return periods;
    }

    void
    read_spectra(const ParameterSection &section,
                 const ModelDefinition &model,
                 SpectrumSettings &spectra)
    {
      const OutputEntries &e = entries_of<OutputEntries>();
      section.read(spectra);
      if (section.given(e.spectrum_periods) && !spectra.wanted)
        section.fail(e.spectrum_periods,
                     fmt::format("without '{} = true' there are no spectra, and this does "
                                 "nothing. Add that entry, or remove this one.",
                                 e.spectra.name()));
      if (!spectra.wanted)
        return;
      if (!has_dynamic_stage(model))
        section.fail(e.spectra,
                     "no stage has a Duration, so that there are no accelerations. Add the entry "
                     "Duration to a stage, or remove this one.");
      if (model.monitors.empty())
        section.fail(e.spectra,
                     "there are no monitors whose accelerations are meant. Add a section Monitors, "
                     "or remove this entry.");
      spectra.periods = section.given(e.spectrum_periods)
                          ? read_coordinates(section.text(e.spectrum_periods))
                          : usual_periods();
      if (spectra.periods.empty() ||
          std::any_of(spectra.periods.begin(), spectra.periods.end(), [](const double period) {
            return !(period > 0.);
          }))
        section.fail(e.spectrum_periods,
                     "this is not a list of periods above 0. Write 'T1, T2, ...' with decimal "
                     "points [s], for example '0.1, 0.2, 0.5'.");
    }
  } // namespace

  void
  read_output(const ParameterValues &values, Parameters &parameters)
  {
    const OutputEntries &e         = entries_of<OutputEntries>();
    const ParameterSection section = values.section<OutputEntries>();
    const std::string directory =
      values.section<TopLevel>().value(entries_of<TopLevel>().output_directory);
    OutputSettings &output  = parameters.output;
    const std::string &file = parameters.parameter_file;
    output.directory = directory.empty() ? (fs::path("results") / fs::path(file).stem()).string()
                                         : resolve(file, directory);
    section.read(output);
    section.read(output.units);
    output.units.named = section.given(e.force_unit) || section.given(e.length_unit);
    if (section.given(e.field_interval) && !may_move(parameters))
      section.fail(e.field_interval,
                   "nothing moves: no stage has a Duration, and 'Solver/Beyond limit load' is not "
                   "dynamic. Add one of these entries, or remove this one.");
    read_spectra(section, parameters.model, output.spectra);
  }
} // namespace fuga
