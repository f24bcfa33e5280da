// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_declarations_h
#define fuga_input_syntax_parameter_declarations_h

#include <fuga/input/syntax/parameter_patterns.h>

#include <deque>
#include <functional>
#include <typeindex>

namespace fuga
{
  class ParameterSection;

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

  /** What has to be done again when an entry changes. */
  enum class Decides
  {
    /** Nothing that a run has computed: a restart may change it. */
    nothing,
    /** Everything, from the elimination of the bodies on. */
    condensation,
    /** The layers of the joints. */
    layers,
    /** The path only: strength of the joints, motion of the ground. */
    path
  };

  /** What is known of one entry before any file is read. */
  struct EntryDeclaration
  {
    std::string name;
    Presence presence = Presence::defaulted;
    std::string default_value;
    /** One of these words, a number of this range, or else any text. */
    std::vector<std::string> words;
    std::optional<NumberRange> range;
    TextContent content = TextContent::words;
    std::string documentation;
    /** Values in default_parameter_text(), one per example section; none = a commented line. */
    std::vector<std::string> examples;
    /** `set NAME =` without a value is meaningful. */
    bool accepts_empty = false;
    Decides decides    = Decides::condensation;
    /** The entry that says the same in another way: one of the two is given. */
    const EntryDeclaration *alternative = nullptr;

    /** What is allowed, in words. */
    std::string
    allowed() const;

    /** Why @p value is not allowed; "" if it is. */
    std::string
    problem(const std::string &value) const;
  };

  /** An entry in the hands of a reader; valid as long as the program runs. */
  struct AnyEntry
  {
    const EntryDeclaration *declaration = nullptr;

    const std::string &
    name() const
    {
      return declaration->name;
    }

    bool
    operator==(const AnyEntry &other) const
    {
      return declaration == other.declaration;
    }
  };

  /** An entry whose value is a Value. */
  template <typename Value>
  struct Entry : AnyEntry
  {
    /** The words of a choice with what they mean. */
    Words<Value> words;
    /** The row of the table, which the constructor of the section goes on filling. */
    EntryDeclaration *row = nullptr;

    /** How a file says @p value. */
    std::string
    word_of(const Value &value) const
    {
      return Pattern<Value>{words}.text_of(value);
    }

    /** This entry and @p other are two ways to say the same. */
    const Entry &
    instead_of(const Entry &other) const
    {
      row->alternative       = other.row;
      other.row->alternative = row;
      return *this;
    }

    const Entry &
    deciding(const Decides what) const
    {
      row->decides = what;
      return *this;
    }
  };

  using Text    = Entry<std::string>;
  using Number  = Entry<double>;
  using Integer = Entry<unsigned int>;

  /**
   * One section of the top level. Each is a class of its own in parameter_entries.h, whose
   * constructor declares the entries in the order in which they are documented and echoed. What it
   * binds to a member of a structure is read into all of its members by ParameterSection::read().
   */
  struct SectionDeclaration
  {
    SectionDeclaration(const std::string &name,
                       const std::string &documentation,
                       const std::vector<std::string> &example_names = {},
                       const bool free_entries                       = false);
    SectionDeclaration(const SectionDeclaration &) = delete;

    /** Empty for the entries outside of all sections, which come first. */
    const std::string name;
    const std::string documentation;
    /** Non-empty: the entries stand in subsections whose names the user chooses; these are the
     * names in default_parameter_text(). */
    const std::vector<std::string> example_names;
    /** The names of the entries are chosen by the user (Constants). */
    const bool free_entries;
    std::deque<EntryDeclaration> entries;

    /** Puts the value of an entry into a member of a target of this type. */
    struct Binding
    {
      std::type_index target;
      std::function<void(const ParameterSection &, void *)> read;
    };
    std::vector<Binding> bindings;

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

    template <typename Value>
    Entry<Value>
    required(const std::string &entry,
             const Pattern<Value> &pattern,
             const std::string &text,
             const std::vector<std::string> &examples)
    {
      return add(entry, Presence::required, "", pattern, text, examples);
    }

    template <typename Value>
    Entry<Value>
    optional(const std::string &entry,
             const Pattern<Value> &pattern,
             const std::string &text,
             const std::vector<std::string> &examples = {})
    {
      return add(entry, Presence::optional, "", pattern, text, examples);
    }

    template <typename Value>
    Entry<Value>
    defaulted(const std::string &entry,
              const std::string &value,
              const Pattern<Value> &pattern,
              const std::string &text,
              const std::vector<std::string> &examples = {})
    {
      return add(entry, Presence::defaulted, value, pattern, text, examples);
    }

    template <typename Target, typename Value>
    Entry<Value>
    required(const std::string &entry,
             Value Target::*member,
             const Pattern<Value> &pattern,
             const std::string &text,
             const std::vector<std::string> &examples)
    {
      return bound(required(entry, pattern, text, examples), member);
    }

    /** The member keeps its value where the entry is absent. */
    template <typename Target, typename Value>
    Entry<Value>
    optional(const std::string &entry,
             Value Target::*member,
             const Pattern<Value> &pattern,
             const std::string &text,
             const std::vector<std::string> &examples = {})
    {
      return bound(optional(entry, pattern, text, examples), member);
    }

    /** The default is that of the member. */
    template <typename Target, typename Value>
    Entry<Value>
    defaulted(const std::string &entry,
              Value Target::*member,
              const Pattern<Value> &pattern,
              const std::string &text,
              const std::vector<std::string> &examples = {})
    {
      return bound(defaulted(entry, pattern.text_of(Target().*member), pattern, text, examples),
                   member);
    }

  protected:
    /** What the entries decide that are declared from here on. */
    Decides decided = Decides::condensation;

  private:
    template <typename Value>
    Entry<Value>
    add(const std::string &entry,
        const Presence presence,
        const std::string &value,
        const Pattern<Value> &pattern,
        const std::string &text,
        const std::vector<std::string> &examples)
    {
      EntryDeclaration &declaration = entries.emplace_back();
      declaration.name              = entry;
      declaration.presence          = presence;
      declaration.default_value     = value;
      for (const auto &word : pattern.words)
        declaration.words.push_back(word.first);
      declaration.range         = pattern.range;
      declaration.content       = pattern.content;
      declaration.documentation = text;
      declaration.examples      = examples;
      declaration.accepts_empty = presence == Presence::defaulted && value.empty();
      declaration.decides       = decided;
      return {{&declaration}, pattern.words, &declaration};
    }

    /** Defined in parameter_values.h. */
    template <typename Target, typename Value>
    Entry<Value>
    bound(const Entry<Value> &entry, Value Target::*member);
  };

  /** The entries of a section. */
  template <typename Section>
  const Section &
  entries_of()
  {
    static const Section section;
    return section;
  }

  /** All sections, in the order in which they are documented and echoed; see parameter_table.cc. */
  const std::vector<std::reference_wrapper<const SectionDeclaration>> &
  parameter_declarations();

  /** Null if there is no such section. */
  const SectionDeclaration *
  find_section(const std::string &name);

  /** The declaration of "Section/Name/Entry"; null if there is none. */
  const EntryDeclaration *
  find_entry(const std::string &full_name);
} // namespace fuga

#endif
