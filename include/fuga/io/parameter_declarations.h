// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_declarations_h
#define fuga_io_parameter_declarations_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>
#include <vector>

namespace fuga
{
  /** Whether an entry has to be there. */
  enum class Presence
  {
    /** Must be given wherever its section stands. */
    required,
    /** May be absent, which means something else than any value. */
    optional,
    /** Has a default. */
    defaulted
  };

  /** What is known of one entry before any file is read. */
  struct EntryDeclaration
  {
    std::string name;
    Presence presence = Presence::defaulted;
    std::string default_value;
    std::shared_ptr<const dealii::Patterns::PatternBase> pattern;
    std::string documentation;
    /** Values in default_parameter_text(), one per example section; none = a commented line. */
    std::vector<std::string> examples;
    /** `set NAME =` without a value is meaningful. */
    bool accepts_empty = false;

    /** What is allowed, in words. */
    std::string
    allowed() const;

    /** Whether the value is one number. */
    bool
    is_number() const;

    /** Whether the value is a text with numbers in it: a table, coordinates. */
    bool
    holds_numbers() const;

    /** The words allowed if the entry is a choice between words, else empty. */
    std::vector<std::string>
    choices() const;
  };

  /** One section of the top level. */
  struct SectionDeclaration
  {
    /** Empty for the entries outside of all sections, which come first. */
    std::string name;
    std::string documentation;
    std::vector<EntryDeclaration> entries;
    /** Non-empty: the entries stand in subsections whose names the user chooses; these are the
     * names in default_parameter_text(). */
    std::vector<std::string> example_names;
    /** The names of the entries are chosen by the user (Constants). */
    bool free_entries = false;

    bool
    has_named_subsections() const
    {
      return !example_names.empty();
    }

    /** Null if there is no such entry. */
    const EntryDeclaration *
    find(const std::string &entry) const;

    std::vector<std::string>
    entry_names() const;
  };

  /** All sections, in the order in which they are documented and echoed; see parameter_table.cc. */
  const std::vector<SectionDeclaration> &
  parameter_declarations();

  /** Null if there is no such section. */
  const SectionDeclaration *
  find_section(const std::string &name);
} // namespace fuga

#endif
