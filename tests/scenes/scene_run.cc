// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/refined_run.h"

#include <fuga/input/read/read_parameters.h>
#include <fuga/run/simulation/phases.h>
#include <fuga/study/adaptive_run.h>

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace fuga::tests
{
  namespace fs = std::filesystem;

  namespace
  {
    /** Load times of levels are sums of fractions: equal up to rounding. */
    constexpr double same_time = 1e-12;

    class Scratch
    {
    public:
      Scratch()
      {
        std::string name = (fs::temp_directory_path() / "fuga_scenes_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
          throw std::runtime_error("no temporary directory");
        path = name;
      }

      ~Scratch()
      {
        std::error_code ignored;
        fs::remove_all(path, ignored);
      }

      std::string path;
      unsigned int n_used = 0;
    };

    /** One field of a record; ends before the separator. */
    std::string
    parse_field(const std::string &text, std::size_t &i)
    {
      std::string field;
      if (i < text.size() && text[i] == '"')
        {
          for (++i;; ++i)
            {
              if (i >= text.size())
                throw std::runtime_error("CSV: quoted field without end");
              if (text[i] == '"')
                {
                  if (i + 1 >= text.size() || text[i + 1] != '"')
                    break;
                  ++i;
                }
              field += text[i];
            }
          ++i;
          return field;
        }
      for (; i < text.size() && text[i] != ',' && text[i] != '\r'; ++i)
        {
          if (text[i] == '"' || text[i] == '\n')
            throw std::runtime_error("CSV: quote or line feed in a plain field");
          field += text[i];
        }
      return field;
    }

    template <int dim>
    ExitCode
    run_model(const Parameters &parameters)
    {
      auto model = std::make_unique<const Model<dim>>(parameters);
      return parameters.accuracy.quantity == AccuracyTarget::Quantity::none
               ? run_all_phases<dim>(std::move(model))
               : AdaptiveRun<dim>(std::move(model)).run();
    }
  } // namespace

  CsvTable
  parse_csv(const std::string &text)
  {
    CsvTable table;
    std::size_t i = 0;
    std::vector<std::string> record;
    while (i < text.size())
      {
        record.push_back(parse_field(text, i));
        if (i < text.size() && text[i] == ',')
          {
            ++i;
            continue;
          }
        if (text.compare(i, 2, "\r\n") != 0)
          throw std::runtime_error("CSV: a record does not end in CR LF");
        i += 2;
        if (table.header.empty())
          table.header = record;
        else if (record.size() != table.header.size())
          throw std::runtime_error("CSV: record " + std::to_string(table.rows.size() + 1) +
                                   " is not as long as the header");
        else
          table.rows.push_back(record);
        record.clear();
      }
    if (!record.empty() || table.header.empty())
      throw std::runtime_error("CSV: the last record is cut off, or there is no header");
    return table;
  }

  std::size_t
  CsvTable::column(const std::string &name) const
  {
    for (std::size_t i = 0; i < header.size(); ++i)
      if (header[i] == name || header[i].substr(0, header[i].find('[')) == name)
        return i;
    throw std::out_of_range("no column " + name);
  }

  const std::string &
  CsvTable::text(const std::size_t row, const std::string &name) const
  {
    return rows.at(row).at(column(name));
  }

  double
  CsvTable::number(const std::size_t row, const std::string &name) const
  {
    return std::stod(text(row, name));
  }

  std::string
  temporary_directory()
  {
    static Scratch scratch;
    const std::string path = scratch.path + "/" + std::to_string(scratch.n_used++);
    fs::create_directory(path);
    return path;
  }

  std::string
  file_text(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    if (!file)
      throw std::runtime_error("no file " + path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  Vector
  SceneRun::values(const std::string &name, const double t) const
  {
    std::vector<std::array<double, 4>> found;
    for (std::size_t r = 0; r < history.rows.size(); ++r)
      if (std::abs(history.number(r, "t") - t) < same_time)
        found.push_back({{history.number(r, "x"),
                          history.number(r, "y"),
                          history.number(r, "z"),
                          history.number(r, name)}});
    if (found.empty())
      throw std::out_of_range("no level at t = " + std::to_string(t));
    std::sort(found.begin(), found.end());
    Vector result;
    for (const auto &row : found)
      result.push_back(row[3]);
    return result;
  }

  std::vector<std::string>
  SceneRun::states(const double t) const
  {
    std::vector<std::pair<std::array<double, 3>, std::string>> found;
    for (std::size_t r = 0; r < history.rows.size(); ++r)
      if (std::abs(history.number(r, "t") - t) < same_time)
        found.push_back({{{history.number(r, "x"), history.number(r, "y"), history.number(r, "z")}},
                         history.text(r, "state")});
    std::sort(found.begin(), found.end());
    std::vector<std::string> result;
    for (const auto &row : found)
      result.push_back(row.second);
    return result;
  }

  std::size_t
  SceneRun::count(const std::string &state, const double t) const
  {
    const auto all = states(t);
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), state));
  }

  double
  SceneRun::resultant(const std::string &name, const double t) const
  {
    for (std::size_t r = 0; r < resultants.rows.size(); ++r)
      if (std::abs(resultants.number(r, "t") - t) < same_time)
        return resultants.number(r, name);
    throw std::out_of_range("no resultants at t = " + std::to_string(t));
  }

  Vector
  SceneRun::event_times(const double after) const
  {
    Vector result;
    for (std::size_t r = 0; r < events.rows.size(); ++r)
      if (events.number(r, "t") > after)
        result.push_back(events.number(r, "t"));
    return result;
  }

  double
  SceneRun::last_t() const
  {
    return history.number(history.rows.size() - 1, "t");
  }

  std::string
  parameter_path(const std::string &file)
  {
    return file.rfind('/', 0) == 0 ? file : std::string(FUGA_SOURCE_DIR) + "/parameters/" + file;
  }

  SceneRun
  run_scene(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = overrides;
    all.push_back("Output/Log=quiet");
    if (std::none_of(overrides.begin(), overrides.end(), [](const std::string &entry) {
          return entry.rfind("Output/Fields=", 0) == 0;
        }))
      all.push_back("Output/Fields=never");
    return run_parameters(read_parameters(parameter_path(file), all));
  }

  SceneRun
  run_parameters(Parameters parameters)
  {
    const std::string directory = temporary_directory();
    parameters.output.directory = directory;
    SceneRun run;
    run.exit_code  = static_cast<int>(parameters.model.dimension == 3 ? run_model<3>(parameters)
                                                                      : run_model<2>(parameters));
    run.events     = parse_csv(file_text(directory + "/events.csv"));
    run.history    = parse_csv(file_text(directory + "/joint_history.csv"));
    run.resultants = parse_csv(file_text(directory + "/resultants.csv"));
    if (fs::exists(directory + "/monitors.csv"))
      run.monitors = parse_csv(file_text(directory + "/monitors.csv"));
    run.summary = nlohmann::json::parse(file_text(directory + "/summary.json"));
    fs::remove_all(directory);
    return run;
  }

  ProgramRun
  run_program(const std::vector<std::string> &arguments)
  {
    const std::string directory = temporary_directory();
    const std::string out = directory + "/out", err = directory + "/err";
    const pid_t child = fork();
    if (child == 0)
      {
        std::vector<std::string> words = {std::string(FUGA_BINARY_DIR) + "/fuga"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char *> argv;
        for (std::string &word : words)
          argv.push_back(word.data());
        argv.push_back(nullptr);
        if (freopen(out.c_str(), "w", stdout) == nullptr ||
            freopen(err.c_str(), "w", stderr) == nullptr)
          _exit(126);
        execv(argv[0], argv.data());
        _exit(127);
      }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
      throw std::runtime_error("the program cannot be started");
    ProgramRun run;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    run.out       = file_text(out);
    run.err       = file_text(err);
    fs::remove_all(directory);
    return run;
  }

  double
  deviation(const Vector &a, const Vector &b, const double factor)
  {
    if (a.size() != b.size())
      return std::numeric_limits<double>::infinity();
    double largest = 0., difference = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        largest    = std::max(largest, std::abs(factor * b[i]));
        difference = std::max(difference, std::abs(a[i] - factor * b[i]));
      }
    if (std::isnan(difference))
      return difference;
    return difference == 0. ? 0. : difference / largest;
  }
} // namespace fuga::tests
