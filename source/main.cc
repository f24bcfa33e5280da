// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/io/law_plot.h>
#include <fuga/io/parameters.h>
#include <fuga/io/threads.h>
#include <fuga/io/version.h>
#include <fuga/simulation.h>
#include <fuga/sweep.h>

#include <deal.II/base/config.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace
{
  using namespace fuga;

  struct CommandLine
  {
    std::string file;
    std::vector<std::string> overrides;
    std::string output_directory;
    unsigned int n_threads = 1;
    bool check_only        = false;
    bool plot_laws         = false;
    bool quiet             = false;
    bool print_parameters  = false;
    bool print_version     = false;
  };

  void
  declare(CLI::App &app, CommandLine &line)
  {
    app.add_option("RUN.prm", line.file, "Parameter file (.prm, or .json with the same names)");
    app
      .add_option("--set",
                  line.overrides,
                  "Replaces an entry: --set \"Section/Entry=value\"; may be repeated")
      ->type_name("\"Section/Entry=value\"")
      ->expected(1)
      ->take_all();
    app.add_option("--output-dir", line.output_directory, "Directory of the results")
      ->type_name("DIR");
    app.add_flag(
      "--check", line.check_only, "Read and check everything, compute and write nothing");
    app.add_flag("--plot-law",
                 line.plot_laws,
                 "Write the laws of all joints as tables and pictures, law_JOINT.csv and .svg; "
                 "compute nothing");
    app.add_option("--threads", line.n_threads, "Threads of the linear algebra")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
    app.add_flag("--quiet", line.quiet, "Say nothing but errors");
    app.add_flag("--print-parameters",
                 line.print_parameters,
                 "Print every entry with its meaning and default");
    app.add_flag("--version", line.print_version, "Print versions");
    app.footer("Exit codes: 0 done, 1 input error, 2 numerical failure, 3 loss of equilibrium "
               "(results up to there are "
               "complete), 4 certificate above its bound.\nFirst steps: fuga --print-parameters > "
               "my.prm; fuga --check my.prm; "
               "fuga my.prm");
  }

  int
  execute(const CommandLine &line)
  {
    if (line.print_version)
      {
        fmt::print("fuga {} (deal.II {})\n", version, DEAL_II_PACKAGE_VERSION);
        return 0;
      }
    if (line.print_parameters)
      {
        fmt::print("{}", default_parameter_text());
        return 0;
      }
    if (line.file.empty())
      throw InputError("No parameter file. Type: fuga RUN.prm   (fuga --help lists all options, "
                       "fuga --print-parameters "
                       "prints a parameter file to begin with)");
    set_threads(line.n_threads);
    Parameters parameters = read_parameters(line.file, line.overrides);
    if (!line.output_directory.empty())
      parameters.output.directory = line.output_directory;
    if (line.quiet)
      parameters.output.log = LogDetail::quiet;
    if (line.plot_laws)
      {
        for (const std::string &file : write_law_plots(parameters))
          if (!line.quiet)
            fmt::print("{}\n", file);
        return 0;
      }
    const Model<2> model(parameters);
    if (line.check_only)
      {
        fmt::print("{}: no errors found.\n", line.file);
        return 0;
      }
    return static_cast<int>(parameters.variants.empty() ? Simulation<2>(model).run()
                                                        : Sweep<2>(model).run());
  }
} // namespace

int
main(int argc, char **argv)
{
  CLI::App app("fuga: how structures and their foundations press, open, stick and slide across "
               "compliant joints");
  CommandLine line;
  declare(app, line);
  try
    {
      app.parse(argc, argv);
      return execute(line);
    }
  catch (const CLI::ParseError &error)
    {
      const int code = app.exit(error);
      return code == 0 ? 0 : static_cast<int>(ExitCode::input_error);
    }
  catch (const InputError &error)
    {
      fmt::print(stderr, "Error: {}\n", error.what());
      return static_cast<int>(ExitCode::input_error);
    }
  catch (const std::exception &error)
    {
      fmt::print(stderr, "Failure: {}\n", error.what());
      return static_cast<int>(ExitCode::numerical_failure);
    }
}
