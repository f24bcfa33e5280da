// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_values_parameter_scanner_h
#define fuga_input_values_parameter_scanner_h

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** The names of the subsections around an entry, outermost first. */
  using SectionPath = std::vector<std::string>;

  /** Return a path in the form "Joints/base"; empty for the top level. */
  std::string
  path_name(const SectionPath &path);

  /**
   * Refuse sections that are nested deeper than any existing one, before their names fill the
   * memory.
   */
  void
  require_shallow(const SectionPath &path, const std::string &origin);

  /** One `set NAME = VALUE` of a file or of the command line; blanks are normalised. */
  struct ScannedEntry
  {
    SectionPath path;
    std::string name;
    std::string value;
    /** "file:line" or the --set option, for messages. */
    std::string origin;

    /** Return the full name, such as "Joints/base/Friction coefficient". */
    std::string
    full_name() const;

    /** Throw the InputError "file:line: Path/Entry = 'value': @p problem_and_remedy". */
    [[noreturn]] void
    fail(const std::string &problem_and_remedy) const;
  };

  /** One opening of a subsection. */
  struct ScannedSection
  {
    SectionPath path;
    std::string origin;
  };

  /**
   * The contents of a parameter file, in its order, before they are compared with what is allowed.
   */
  struct ParameterScan
  {
    std::string file;
    std::vector<ScannedSection> sections;
    std::vector<ScannedEntry> entries;
    /** Whether this is a variant of a sweep. */
    bool is_variant = false;
    /** The full names of the entries that the sweep varies, with all their values. */
    std::map<std::string, std::vector<std::string>> swept;
  };

  /**
   * Read a file in the format given by its extension. Section Sweep repeats the sections of the
   * file inside itself: "Sweep", "Joints", "base" with the entry "Cohesion" is the same as "Sweep"
   * with the entry "Joints/base/Cohesion" and is converted to that.
   * @throws InputError for a file that cannot be read, is empty or breaks the rules of its format.
   */
  ParameterScan
  scan_parameter_file(const std::string &file);

  /**
   * Scan text in the format of deal.II's ParameterHandler: `subsection NAME`, `set NAME = VALUE`,
   * `end`, comments from # to the end of the line, lines continued by a backslash at their end.
   */
  ParameterScan
  scan_prm(const std::string &file, const std::string &text);

  /** Scan nested JSON objects of strings, numbers and truth values. */
  ParameterScan
  scan_json(const std::string &file, const std::string &text);

  /**
   * Apply the --set options in their order: the value replaces the one in the file, or is added; an
   * empty value removes the entry. Two options for the same entry are an error.
   */
  void
  apply_overrides(ParameterScan &scan, const std::vector<std::string> &overrides);
} // namespace fuga

#endif
