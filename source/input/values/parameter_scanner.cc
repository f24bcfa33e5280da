// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/parameter_scanner.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace fuga
{
  namespace
  {
    std::string
    read_text(const std::string &file)
    {
      namespace fs = std::filesystem;
      std::error_code ignored;
      const fs::file_status status = fs::status(file, ignored);
      if (status.type() == fs::file_type::not_found)
        throw InputError(
          fmt::format("{}: the parameter file does not exist. Check its name and the "
                      "current directory.",
                      file));
      if (fs::is_directory(status))
        throw InputError(fmt::format("{}: this is a directory, not a parameter file. Give the name "
                                     "of a .prm or .json file in it.",
                                     file));
      std::ifstream stream(file, std::ios::binary);
      std::ostringstream text;
      if (stream && stream.peek() != std::ifstream::traits_type::eof())
        text << stream.rdbuf();
      if (!stream.is_open() || stream.bad())
        throw InputError(
          fmt::format("{}: the parameter file cannot be read. Check its permissions.", file));
      return text.str();
    }


    /** Turn an entry in a subsection of Sweep into one of Sweep itself. */
    void
    fold_into_sweep(ScannedEntry &entry)
    {
      if (entry.path.size() < 2 || entry.path.front() != entries_of<SweepEntries>().name)
        return;
      entry.name = path_name({entry.path.begin() + 1, entry.path.end()}) + "/" + entry.name;
      entry.path.resize(1);
    }


    void
    fold_into_sweep(ParameterScan &scan)
    {
      for (ScannedEntry &entry : scan.entries)
        fold_into_sweep(entry);
      const auto is_inside = [](const ScannedSection &section) {
        return section.path.size() > 1 && section.path.front() == entries_of<SweepEntries>().name;
      };
      scan.sections.erase(std::remove_if(scan.sections.begin(), scan.sections.end(), is_inside),
                          scan.sections.end());
    }


    /** Reads the lines of a .prm file one after the other. */
    class PrmScanner
    {
    public:
      PrmScanner(const std::string &file, const std::string &text) : lines(text)
      {
        scan.file = file;
      }

      ParameterScan
      run()
      {
        std::string line;
        while (next_line(line))
          if (!line.empty())
            take(line);
        if (!open_at.empty())
          throw InputError(
            fmt::format("{}: subsection '{}' is never closed. Add the missing 'end'.",
                        open_at.back(),
                        path_name(path)));
        return std::move(scan);
      }

    private:
      /** Get one line without comment; continued lines become one, which has the number of the
       * first. */
      bool
      next_line(std::string &line)
      {
        line.clear();
        first_line   = last_line + 1;
        bool is_more = true;
        std::string physical;
        while (is_more)
          {
            if (!std::getline(lines, physical))
              {
                if (last_line + 1 > first_line)
                  throw InputError(fmt::format("{}:{}: the last line of the file ends with a "
                                               "backslash. Remove it or add the rest of the line.",
                                               scan.file,
                                               last_line));
                return false;
              }
            ++last_line;
            physical = normalise_blanks(physical.substr(0, physical.find('#')));
            is_more  = !physical.empty() && physical.back() == '\\';
            if (is_more)
              physical.pop_back();
            line += physical;
          }
        line = normalise_blanks(line);
        return true;
      }

      std::string
      origin() const
      {
        return fmt::format("{}:{}", scan.file, first_line);
      }

      void
      take(const std::string &line)
      {
        const std::string word = line.substr(0, line.find(' '));
        const std::string rest = word.size() < line.size() ? line.substr(word.size() + 1) : "";
        if (word == "set" || word == "SET")
          take_entry(rest);
        else if (word == "subsection" || word == "SUBSECTION")
          open_section(rest);
        else if (word == "end" || word == "END")
          close_section(rest);
        else if (word == "include")
          throw InputError(
            fmt::format("{}: '{}': files cannot be included. Copy the text, or change "
                        "single entries with --set.",
                        origin(),
                        line));
        else
          throw InputError(fmt::format(
            "{}: '{}' is none of 'set NAME = VALUE', 'subsection NAME' and "
            "'end'. {}",
            origin(),
            line,
            line.find('=') == std::string::npos ? "Comments begin with '#'."
                                                : "Write 'set' before the name of the entry."));
      }

      void
      take_entry(const std::string &text)
      {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
          throw InputError(
            fmt::format("{}: 'set {}' has no '='. Write 'set NAME = VALUE'.", origin(), text));
        const std::string name = normalise_blanks(text.substr(0, equals));
        if (name.empty())
          throw InputError(fmt::format("{}: 'set {}' has no name before the '='. Write "
                                       "'set NAME = VALUE'.",
                                       origin(),
                                       text));
        scan.entries.push_back({path, name, normalise_blanks(text.substr(equals + 1)), origin()});
      }

      void
      open_section(const std::string &name)
      {
        if (name.empty())
          throw InputError(
            fmt::format("{}: 'subsection' without a name. Write 'subsection NAME'.", origin()));
        path.push_back(name);
        require_shallow(path, origin());
        open_at.push_back(origin());
        scan.sections.push_back({path, origin()});
      }

      void
      close_section(const std::string &rest)
      {
        if (!rest.empty())
          throw InputError(fmt::format(
            "{}: text after 'end': '{}'. Remove it or begin it with '#'.", origin(), rest));
        if (path.empty())
          throw InputError(
            fmt::format("{}: 'end' without a subsection to close. Remove it, or look "
                        "for a 'subsection' line that is missing above.",
                        origin()));
        path.pop_back();
        open_at.pop_back();
      }

      std::istringstream lines;
      ParameterScan scan;
      SectionPath path;
      std::vector<std::string> open_at;
      unsigned int first_line = 1;
      unsigned int last_line  = 0;
    };
  } // namespace


  std::string
  path_name(const SectionPath &path)
  {
    std::string result;
    for (const std::string &name : path)
      result += (result.empty() ? "" : "/") + name;
    return result;
  }


  void
  require_shallow(const SectionPath &path, const std::string &origin)
  {
    constexpr std::size_t deepest = 5; // slightly more than any section that exists
    if (path.size() > deepest)
      throw InputError(
        fmt::format("{}: section '{}' lies {} sections deep, more than any that exists. "
                    "Look for one above that is not closed.",
                    origin,
                    path_name(path),
                    path.size()));
  }


  std::string
  ScannedEntry::full_name() const
  {
    return path.empty() ? name : path_name(path) + "/" + name;
  }


  void
  ScannedEntry::fail(const std::string &problem_and_remedy) const
  {
    throw InputError(
      fmt::format("{}: {} = '{}': {}", origin, full_name(), value, problem_and_remedy));
  }


  ParameterScan
  scan_prm(const std::string &file, const std::string &text)
  {
    return PrmScanner(file, text).run();
  }


  ParameterScan
  scan_parameter_file(const std::string &file)
  {
    std::string text            = read_text(file);
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension != ".prm" && extension != ".json")
      throw InputError(
        fmt::format("{}: the extension '{}' is unknown. The name of a parameter file "
                    "ends in .prm or .json.",
                    file,
                    extension));
    if (text.find('\0') != std::string::npos)
      throw InputError(
        fmt::format("{}: the file contains binary data. A parameter file is plain text "
                    "(UTF-8).",
                    file));
    if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
      text.erase(0, 3);
    if (normalise_blanks(text).empty())
      throw InputError(
        fmt::format("{}: the parameter file is empty. 'fuga --print-parameters' prints "
                    "one to begin with.",
                    file));
    ParameterScan scan = extension == ".json" ? scan_json(file, text) : scan_prm(file, text);
    fold_into_sweep(scan);
    return scan;
  }


  void
  apply_overrides(ParameterScan &scan, const std::vector<std::string> &overrides)
  {
    std::map<std::string, std::string> applied;
    for (const std::string &text : overrides)
      {
        const std::string origin = "--set \"" + text + "\"";
        const std::size_t equals = text.find('=');
        SectionPath path         = split_pieces(text.substr(0, equals), '/');
        if (equals == std::string::npos || path.empty() ||
            std::find(path.begin(), path.end(), "") != path.end())
          throw InputError(
            fmt::format("{}: this is not of the form \"Section/Sub/Entry=value\".", origin));
        const std::string name = path.back();
        path.pop_back();
        ScannedEntry entry{path, name, normalise_blanks(text.substr(equals + 1)), origin};
        fold_into_sweep(entry);

        const auto [earlier, is_new] = applied.emplace(entry.full_name(), origin);
        if (!is_new)
          throw InputError(fmt::format("{}: {} was already set by {}. Keep one of the two.",
                                       origin,
                                       entry.full_name(),
                                       earlier->second));
        const auto same =
          std::find_if(scan.entries.begin(), scan.entries.end(), [&](const auto &e) {
            return e.path == entry.path && e.name == entry.name;
          });
        if (entry.value.empty())
          {
            if (same == scan.entries.end())
              throw InputError(
                fmt::format("{}: an empty value takes an entry out of the file, but {} "
                            "is not set in {}. Give a value.",
                            origin,
                            entry.full_name(),
                            scan.file));
            scan.entries.erase(same);
          }
        else if (same == scan.entries.end())
          scan.entries.push_back(entry);
        else
          *same = entry;
      }
  }
} // namespace fuga
