// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/bodies/processes.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/output/files/directory_lock.h>
#include <fuga/output/files/output_files.h>
#include <fuga/output/files/version.h>
#include <fuga/output/tables/law_table.h>
#include <fuga/output/tables/report.h>
#include <fuga/run/journal/passing_line.h>
#include <fuga/run/simulation/phases.h>
#include <fuga/run/simulation/threads.h>
#include <fuga/study/adaptive_run.h>
#include <fuga/study/model_check.h>
#include <fuga/study/sweep.h>

#include <deal.II/base/config.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace
{
  using namespace fuga;

  constexpr const char *first_steps =
    "no parameter file. What to type:\n\n"
    "  fuga my.prm                        compute; the results go to results/my\n"
    "  fuga --check my.prm                read and check everything, compute nothing\n"
    "  fuga report results/my             make report.html and report_short.html there\n"
    "  fuga --print-parameters > my.prm   a file with all entries and their meanings to begin "
    "with\n"
    "  fuga --help                        all options\n\n"
    "A mesh comes from Gmsh, with named physical groups. README.md leads from nothing to a first "
    "result; parameters/ has examples.";

  struct CommandLine
  {
    std::string file;
    std::vector<std::string> overrides;
    std::string output_directory;
    std::string reported_directory;
    unsigned int n_threads = 1;
    bool check_only        = false;
    bool plot_laws         = false;
    bool restart           = false;
    bool quiet             = false;
    bool print_parameters  = false;
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
    app.add_flag("--check",
                 line.check_only,
                 "Read and check everything, say what it adds up to, compute and write nothing");
    app.add_flag(
      "--plot-law",
      line.plot_laws,
      "Write the laws of all joints as tables, law_JOINT.csv, which 'fuga report' draws; "
      "compute nothing");
    app.add_flag("--restart",
                 line.restart,
                 "Continue the run in the directory of the results from its last checkpoint");
    app.add_option("--threads", line.n_threads, "Threads of the linear algebra")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
    app.add_flag("--quiet", line.quiet, "Say nothing but errors");
    app.add_flag("--print-parameters",
                 line.print_parameters,
                 "Print every entry with its meaning and default");
    app.set_version_flag("--version",
                         fmt::format("fuga {} (deal.II {})", version, DEAL_II_PACKAGE_VERSION),
                         "Print versions");
    app
      .add_subcommand("report",
                      "Makes DIR/report.html and DIR/report_short.html of a finished run, and "
                      "DIR/laws.html of the tables of --plot-law")
      ->add_option("DIR", line.reported_directory, "Directory of the results")
      ->required();
    app.footer("Exit codes: 0 done, 1 input error, 2 numerical failure, 3 loss of equilibrium "
               "(results up to there are complete), 4 certificate above its bound, 5 a result file "
               "cannot be written, 130 or 143 interrupted (Ctrl-C, SIGTERM).");
  }

  Checkpoint
  find_checkpoint(const Parameters &parameters)
  {
    if (!parameters.variants.empty())
      throw InputError(fmt::format("{}: a sweep cannot be restarted. Its variants are short runs: "
                                   "run without --restart, or take the section Sweep out.",
                                   parameters.parameter_file));
    if (parameters.accuracy.quantity != AccuracyTarget::Quantity::none)
      throw InputError(fmt::format(
        "{}: a run that finds its mesh cannot be restarted. Run without --restart; with "
        "'Quantity = none' the mesh of the file can be run and restarted.",
        parameters.accuracy.origin));
    Checkpoint checkpoint = read_checkpoint(parameters.output.directory);
    check_same_problem(checkpoint, parameters);
    return checkpoint;
  }

  int
  report_complete_run(const Checkpoint &checkpoint, const Parameters &parameters)
  {
    if (parameters.output.log != LogDetail::quiet)
      fmt::print("The run in {} is complete: {}, t = {:.12g}. There is nothing left to compute and "
                 "nothing was changed.\n",
                 parameters.output.directory,
                 checkpoint.verdict,
                 checkpoint.cut.result.t);
    return checkpoint.exit_code;
  }

  // Write the report after a run. If that fails, the results and the verdict are still valid.
  void
  report_after_run(const OutputSettings &output)
  {
    try
      {
        make_report(output.directory, output.log == LogDetail::quiet);
      }
    catch (const std::exception &error)
      {
        fmt::print(stderr, "No report: {}\n", error.what());
      }
  }

  /** Return what a run that ended early has left, and how to continue. */
  std::string
  advice(const std::string &directory)
  {
    const bool has_checkpoint =
      std::filesystem::exists(std::filesystem::path(directory) / checkpoint_file_name);
    return fmt::format(" The results in {} are complete up to there{}.",
                       directory,
                       has_checkpoint
                         ? "; the same command with --restart goes on from the last checkpoint"
                         : ", but there is no checkpoint to go on from");
  }

  template <typename Run>
  ExitCode
  with_advice(const Run &run, const std::string &directory)
  {
    try
      {
        return run();
      }
    catch (const Interrupted &end)
      {
        throw Interrupted(end.what() + advice(directory));
      }
    catch (const WriteFailure &failure)
      {
        throw WriteFailure(failure.what() + advice(directory));
      }
  }

  void
  report_check(const CheckedModel &checked, const CommandLine &line)
  {
    if (line.quiet)
      return;
    for (const std::string &text : checked.echo)
      fmt::print("{}\n", text);
    for (const std::string &text : checked.warnings)
      fmt::print("Warning: {}\n", text);
    const std::size_t n = checked.warnings.size();
    fmt::print("{}: no errors found{}.\n",
               line.file,
               n == 0   ? ""
               : n == 1 ? ", one warning"
                        : fmt::format(", {} warnings", n));
  }

  template <int dim>
  int
  compute(const CommandLine &line,
          const Parameters &parameters,
          const std::optional<Checkpoint> &checkpoint)
  {
    if (line.check_only)
      {
        report_check(check_model<dim>(parameters), line);
        return 0;
      }
    interruption::listen();
    std::signal(SIGXFSZ, SIG_IGN); // a limit of the size of files is noticed where they are written
    auto waiting = std::make_unique<PassingLine>("Reading the mesh, condensing the bodies ...",
                                                 parameters.output.log != LogDetail::quiet);
    std::unique_ptr<Sweep<dim>> sweep;
    std::unique_ptr<const Model<dim>> model;
    if (parameters.of_sweep)
      sweep = std::make_unique<Sweep<dim>>(parameters);
    else
      model = std::make_unique<const Model<dim>>(
        parameters, checkpoint ? checkpoint->construction : ConstructionState());
    waiting.reset();
    const auto run = [&] {
      if (sweep != nullptr)
        return sweep->run();
      if (parameters.accuracy.quantity != AccuracyTarget::Quantity::none)
        return AdaptiveRun<dim>(std::move(model)).run();
      return run_all_phases<dim>(std::move(model), checkpoint ? &*checkpoint : nullptr);
    };
    const ExitCode code = with_advice(run, parameters.output.directory);
    if (parameters.output.report && code != ExitCode::input_error && processes::is_first())
      report_after_run(parameters.output);
    return static_cast<int>(code);
  }

  int
  execute(const CommandLine &line)
  {
    if (line.print_parameters)
      {
        fmt::print("{}", default_parameter_text());
        return 0;
      }
    if (!line.reported_directory.empty())
      return !processes::is_first() ? processes::no_code
                                    : make_report(line.reported_directory, line.quiet);
    if (line.file.empty())
      throw InputError(first_steps);
    set_threads(line.n_threads);
    Parameters parameters = read_parameters(line.file, line.overrides);
    if (!line.output_directory.empty())
      parameters.output.directory = line.output_directory;
    if (line.quiet)
      parameters.output.log = LogDetail::quiet;
    if (line.plot_laws)
      {
        const std::vector<std::string> files = write_law_tables(parameters);
        if (!line.quiet)
          fmt::print("{}\nfuga report {} draws them.\n",
                     fmt::join(files, "\n"),
                     parameters.output.directory);
        return 0;
      }
    std::optional<DirectoryLock> lock;
    if (!line.check_only)
      lock.emplace(parameters.output.directory);
    std::optional<Checkpoint> checkpoint;
    if (line.restart)
      {
        checkpoint = find_checkpoint(parameters);
        if (is_complete(*checkpoint, parameters))
          return report_complete_run(*checkpoint, parameters);
      }
    return parameters.model.dimension == 3 ? compute<3>(line, parameters, checkpoint)
                                           : compute<2>(line, parameters, checkpoint);
  }
} // namespace

int
main(int argc, char **argv)
{
  CLI::App app("fuga: how structures and their foundations press, open, stick and slide across "
               "compliant joints");
  CommandLine line;
  declare(app, line);
  processes::join();
  int code = processes::no_code;
  std::string complaint;
  try
    {
      app.parse(argc, argv);
      code = execute(line);
    }
  catch (const CLI::ParseError &error)
    {
      std::ostringstream text;
      const int of_parser = app.exit(error, std::cout, text);
      code      = static_cast<int>(of_parser == 0 ? ExitCode::done : ExitCode::input_error);
      complaint = text.str();
    }
  catch (const InputError &error)
    {
      code      = static_cast<int>(ExitCode::input_error);
      complaint = fmt::format("Error: {}\n", error.what());
    }
  catch (const Interrupted &end)
    {
      code      = interruption::exit_code();
      complaint = fmt::format("{}{}\n", processes::have_terminal() ? "\n" : "", end.what());
    }
  catch (const WriteFailure &failure)
    {
      code      = static_cast<int>(ExitCode::not_written);
      complaint = fmt::format("Error: {}\n", failure.what());
    }
  catch (const processes::Separated &)
    {
    }
  catch (const std::exception &error)
    {
      code      = static_cast<int>(ExitCode::numerical_failure);
      complaint = fmt::format("Failure: {}\n", error.what());
    }
  code = processes::leave(code, complaint);
  return code == processes::no_code ? static_cast<int>(ExitCode::numerical_failure) : code;
}
