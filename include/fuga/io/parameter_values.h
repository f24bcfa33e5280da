// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_values_h
#define fuga_io_parameter_values_h

#include <fuga/base/input_errors.h>
#include <fuga/io/constant_expressions.h>
#include <fuga/io/parameter_scanner.h>
#include <fuga/io/unit_text.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  class ParameterValues;

  /** The entries of one section (or named subsection) with their values; a light view. */
  class ParameterSection
  {
  public:
    ParameterSection(const ParameterValues &values, const SectionPath &path);

    /** The innermost name. */
    const std::string &
    name() const
    {
      return path.back();
    }

    /** Whether the entry stands in the file or in an override. */
    bool
    given(const std::string &entry) const;

    /** Value or default. */
    std::string
    text(const std::string &entry) const;

    double
    number(const std::string &entry) const;

    unsigned int
    integer(const std::string &entry) const;

    /** The pieces between commas. @throws InputError for empty or repeated ones. */
    std::vector<std::string>
    list(const std::string &entry) const;

    /** The values that the variants of a sweep give the entry; none if it is not varied. */
    std::vector<std::string>
    swept(const std::string &entry) const;

    /** Where the entry is set, else where the section is opened, else the file. */
    std::string
    origin(const std::string &entry = "") const;

    /** Throws the InputError "file:line: Path/Entry = 'value': @p problem_and_remedy". */
    [[noreturn]] void
    fail(const std::string &entry, const std::string &problem_and_remedy) const;

    /** The same for the section as a whole. */
    [[noreturn]] void
    fail(const std::string &problem_and_remedy) const;

  private:
    friend class ParameterValues;

    const ParameterValues *values;
    SectionPath path;
  };

  /**
   * The values of a scanned file within what is declared. The constructor refuses unknown,
   * repeated, missing and ill-formed entries; what it accepts sits in a dealii::ParameterHandler.
   * Expressions of constants are numbers from then on.
   *
   * Errors are collected. A section with an error is broken: whatever else would be found in it, or
   * in what depends on it, may follow from the first error and is not looked at.
   */
  class ParameterValues
  {
  public:
    /** Errors of entries go to @p errors. @throws InputError for sections that are not known. */
    ParameterValues(const ParameterScan &scan, InputErrors &errors);

    /**
     * Runs @p action, which reads @p section, unless the section is broken; it is from then on if
     * the action throws an InputError, which is collected.
     */
    void
    attempt(const ParameterSection &section, const std::function<void()> &action) const;

    bool
    is_broken(const ParameterSection &section) const;

    /** Whether a section, or a subsection of it, is broken. */
    bool
    is_broken(const std::string &name) const;

    ParameterSection
    section(const std::string &name) const;

    /** The named subsections of a section, in the order of the file. */
    std::vector<ParameterSection>
    subsections(const std::string &name) const;

    std::vector<std::string>
    subsection_names(const std::string &name) const;

    /** The numbers of section Constants. */
    std::map<std::string, double>
    constants() const;

    /** (path, value) of all entries with a value, in the order of the declarations. */
    std::vector<std::pair<std::string, std::string>>
    echo() const;

    const std::string &
    file() const
    {
      return file_name;
    }

    /** Whether this is one of the variants of a sweep. */
    bool
    is_variant() const
    {
      return of_sweep;
    }

  private:
    friend class ParameterSection;

    void
    attempt(const SectionPath &path, const std::function<void()> &action) const;

    void
    find_units(const ParameterScan &scan);

    void
    add_section(const ScannedSection &section);

    void
    declare(const SectionPath &path);

    void
    add_constant(const ScannedEntry &entry);

    void
    add_entry(const ScannedEntry &entry);

    void
    refuse_unknown(const ScannedEntry &entry) const;

    /** The entry with expressions of constants evaluated. */
    ScannedEntry
    with_numbers(const ScannedEntry &entry, const EntryDeclaration &declaration) const;

    void
    set(const ScannedEntry &entry, const EntryDeclaration &declaration);

    void
    require_entries(const SectionPath &path) const;

    /** All paths that can hold entries: the declared sections and the subsections of the file. */
    std::vector<SectionPath>
    all_paths() const;

    std::string file_name;
    const bool of_sweep;
    const std::map<std::string, std::vector<std::string>> swept;
    InputErrors &errors;
    mutable std::set<SectionPath> broken;
    Units units;
    ConstantExpressions expressions;
    dealii::ParameterHandler handler;
    std::map<std::string, std::vector<SectionPath>> subsection_paths;
    std::map<SectionPath, std::string> section_origins;
    std::map<std::string, std::string> entry_origins;
    std::vector<std::string> constant_names;
  };
} // namespace fuga

#endif
