// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_values_parameter_values_h
#define fuga_input_values_parameter_values_h

#include <fuga/base/input_errors.h>
#include <fuga/input/syntax/constant_expressions.h>
#include <fuga/input/syntax/parameter_declarations.h>
#include <fuga/input/syntax/unit_text.h>
#include <fuga/input/values/parameter_scanner.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  class ParameterValues;

  /** A lightweight view of the entries of one section (or named subsection) with their values. */
  class ParameterSection
  {
  public:
    ParameterSection(const ParameterValues &values, const SectionPath &path);

    /** Return the innermost name. */
    const std::string &
    name() const
    {
      return path.back();
    }

    /** Return whether the entry is given in the file or in an override. */
    bool
    given(const AnyEntry &entry) const;

    /** Return the meaning of the entry, or of its default. */
    template <typename Value>
    Value
    value(const Entry<Value> &entry) const
    {
      if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, unsigned int>)
        return static_cast<Value>(std::stod(text(entry)));
      else if constexpr (std::is_same_v<Value, std::string>)
        return text(entry);
      else
        return value_of_word(entry, text(entry));
    }

    /** Return the value of the entry, or @p otherwise if it is not given. */
    template <typename Value>
    Value
    value_or(const Entry<Value> &entry, const Value &otherwise) const
    {
      return given(entry) ? value(entry) : otherwise;
    }

    /** Read all entries that the section binds to members of a Target. */
    template <typename Target>
    void
    read(Target &target) const
    {
      for (const SectionDeclaration::Binding &binding : declaration().bindings)
        if (binding.target == typeid(Target))
          binding.read(*this, &target);
    }

    /** Call @p action with all entries that are given, in the order of their declarations. */
    template <typename Action>
    void
    for_given(const Action &action) const
    {
      for (const EntryDeclaration &entry : declaration().entries)
        if (given(AnyEntry{&entry}))
          action(AnyEntry{&entry});
    }

    /** Return the value or the default, as it is written. */
    std::string
    text(const AnyEntry &entry) const;

    /** Return the pieces between commas. @throws InputError for empty or repeated ones. */
    std::vector<std::string>
    list(const AnyEntry &entry) const;

    /** Return the values of the entry in the variants of a sweep; none if it is not varied. */
    std::vector<std::string>
    swept(const AnyEntry &entry) const;

    /**
     * Return the place where the entry is set, otherwise where the section is opened, otherwise the
     * file.
     */
    std::string
    origin(const AnyEntry &entry) const;

    std::string
    origin() const;

    /** Throw the InputError "file:line: Path/Entry = 'value': @p problem_and_remedy". */
    [[noreturn]] void
    fail(const AnyEntry &entry, const std::string &problem_and_remedy) const;

    /** Throw such an InputError for the section as a whole. */
    [[noreturn]] void
    fail(const std::string &problem_and_remedy) const;

  private:
    friend class ParameterValues;

    std::string
    full_name(const AnyEntry &entry) const;

    const SectionDeclaration &
    declaration() const;

    const ParameterValues *values;
    SectionPath path;
  };

  /** Return the meaning of a word of a choice. */
  template <typename Value>
  Value
  value_of_word(const Entry<Value> &entry, const std::string &word)
  {
    for (const auto &[known, value] : entry.words)
      if (known == word)
        return value;
    return entry.words.front().second; // of an optional entry that is absent
  }

  template <typename Target, typename Value>
  Entry<Value>
  SectionDeclaration::bound(const Entry<Value> &entry, Value Target::*member)
  {
    bindings.push_back(
      {typeid(Target), [entry, member](const ParameterSection &section, void *target) {
         if (entry.declaration->presence != Presence::optional || section.given(entry))
           static_cast<Target *>(target)->*member = section.value(entry);
       }});
    return entry;
  }

  /**
   * The values of a scanned file, checked against the declarations. The constructor refuses
   * unknown, repeated, missing and ill-formed entries; all others count as given. Expressions of
   * constants are numbers from then on.
   *
   * Errors are collected. A section with an error is broken: any further error in it, or in what
   * depends on it, may follow from the first one and is not searched for.
   */
  class ParameterValues
  {
  public:
    /** Errors of entries are added to @p errors. @throws InputError for unknown sections. */
    ParameterValues(const ParameterScan &scan, InputErrors &errors);

    /**
     * Run @p action, which reads @p section, unless the section is broken. If the action throws an
     * InputError, this is collected and the section is broken from then on.
     */
    void
    attempt(const ParameterSection &section, const std::function<void()> &action) const;

    bool
    is_broken(const ParameterSection &section) const;

    /** Return whether a section, or a subsection of it, is broken. */
    template <typename Section>
    bool
    is_broken() const
    {
      return is_broken(entries_of<Section>().name);
    }

    template <typename Section>
    ParameterSection
    section() const
    {
      return section(entries_of<Section>().name);
    }

    /** Return the named subsections of a section, in the order of the file. */
    template <typename Section>
    std::vector<ParameterSection>
    subsections() const
    {
      return subsections(entries_of<Section>().name);
    }

    template <typename Section>
    std::vector<std::string>
    subsection_names() const
    {
      return subsection_names(entries_of<Section>().name);
    }

    /** Return the numbers of section Constants. */
    std::map<std::string, double>
    constants() const;

    /** Return (path, value) of all entries with a value, in the order of the declarations. */
    std::vector<std::pair<std::string, std::string>>
    echo() const;

    const std::string &
    file() const
    {
      return file_name;
    }

    /** Return whether this is one of the variants of a sweep. */
    bool
    is_variant() const
    {
      return of_sweep;
    }

  private:
    friend class ParameterSection;

    bool
    is_broken(const std::string &name) const;

    ParameterSection
    section(const std::string &name) const;

    std::vector<ParameterSection>
    subsections(const std::string &name) const;

    std::vector<std::string>
    subsection_names(const std::string &name) const;

    void
    attempt(const SectionPath &path, const std::function<void()> &action) const;

    void
    find_units(const ParameterScan &scan);

    void
    add_section(const ScannedSection &section);

    void
    add_constant(const ScannedEntry &entry);

    void
    add_entry(const ScannedEntry &entry);

    void
    refuse_unknown(const ScannedEntry &entry) const;

    /** Return the entry with expressions of constants evaluated. */
    ScannedEntry
    with_numbers(const ScannedEntry &entry, const EntryDeclaration &declaration) const;

    void
    set(const ScannedEntry &entry, const EntryDeclaration &declaration);

    /** Return the value in the file, otherwise the default. */
    std::string
    value_of(const std::string &full_name, const EntryDeclaration &declaration) const;

    void
    require_entries(const SectionPath &path) const;

    /**
     * Return all paths that can contain entries: the declared sections and the subsections of the
     * file.
     */
    std::vector<SectionPath>
    all_paths() const;

    std::string file_name;
    const bool of_sweep;
    const std::map<std::string, std::vector<std::string>> swept;
    InputErrors &errors;
    mutable std::set<SectionPath> broken;
    Units units;
    ConstantExpressions expressions;
    std::map<std::string, std::string> given_values;
    std::map<std::string, std::vector<SectionPath>> subsection_paths;
    std::map<SectionPath, std::string> section_origins;
    std::map<std::string, std::string> entry_origins;
    std::vector<std::string> constant_names;
  };
} // namespace fuga

#endif
