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

  /** Tells whether an entry has to be given. */
  enum class Presence
  {
    /** The entry must be given wherever its section occurs. */
    required,
    /** The entry may be absent, which means something different from any value. */
    optional,
    /** The entry has a default. */
    defaulted
  };

  /** The part of a computation that has to be repeated when an entry changes. */
  enum class Decides
  {
    /** None of the results of a run: a restart may change the entry. */
    nothing,
    /** Everything, starting with the elimination of the bodies. */
    condensation,
    /** The layers of the joints. */
    layers,
    /** Only the path: strength of the joints, motion of the ground. */
    path
  };

  /** The properties of one entry that are known before any file is read. */
  struct EntryDeclaration
  {
    std::string name;
    Presence presence = Presence::defaulted;
    std::string default_value;
    /** The allowed values: one of these words, a number in this range, or otherwise any text. */
    std::vector<std::string> words;
    std::optional<NumberRange> range;
    TextContent content = TextContent::words;
    std::string documentation;
    /** Values in default_parameter_text(), one per example section; none = a commented line. */
    std::vector<std::string> examples;
    /** Whether `set NAME =` without a value is meaningful. */
    bool accepts_empty = false;
    Decides decides    = Decides::condensation;
    /** An entry that expresses the same in another way: one of the two is given. */
    const EntryDeclaration *alternative = nullptr;

    /** Return the allowed values in words. */
    std::string
    allowed() const;

    /** Return the reason why @p value is not allowed; "" if it is allowed. */
    std::string
    problem(const std::string &value) const;
  };

  /** An entry as used by readers; valid as long as the program runs. */
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

  /** An entry whose value is of type Value. */
  template <typename Value>
  struct Entry : AnyEntry
  {
    /** The words of a choice and their meanings. */
    Words<Value> words;
    /** The row of the table, which the constructor of the section continues to fill. */
    EntryDeclaration *row = nullptr;

    /** Return the text for @p value in a file. */
    std::string
    word_of(const Value &value) const
    {
      return Pattern<Value>{words}.text_of(value);
    }

    /** Declare that this entry and @p other are two ways to express the same. */
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
   * One section of the top level. Each section is a class of its own in parameter_entries.h, whose
   * constructor declares the entries in the order in which they are documented and echoed.
   * ParameterSection::read() reads the entries that are bound to members of a structure into these
   * members.
   */
  struct SectionDeclaration
  {
    SectionDeclaration(const std::string &name,
                       const std::string &documentation,
                       const std::vector<std::string> &example_names = {},
                       const bool free_entries                       = false);
    SectionDeclaration(const SectionDeclaration &) = delete;

    /** Name of the section; empty for the entries outside of all sections, which come first. */
    const std::string name;
    const std::string documentation;
    /**
     * If not empty, the entries are in subsections whose names the user chooses; these are the
     * names in default_parameter_text().
     */
    const std::vector<std::string> example_names;
    /** Whether the names of the entries are chosen by the user (Constants). */
    const bool free_entries;
    std::deque<EntryDeclaration> entries;

    /** Reads the value of an entry into a member of a target of this type. */
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

    /** Return the entry with this name; null if there is none. */
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

    /** Declare an optional entry; the member keeps its value if the entry is absent. */
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

    /** Declare an entry whose default is that of the member. */
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
    /** The part of the computation on which the entries declared from here on decide. */
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

  /** Return the entries of a section. */
  template <typename Section>
  const Section &
  entries_of()
  {
    static const Section section;
    return section;
  }

  /**
   * Return all sections in the order in which they are documented and echoed, see
   * parameter_table.cc.
   */
  const std::vector<std::reference_wrapper<const SectionDeclaration>> &
  parameter_declarations();

  /** Return the section with this name; null if there is none. */
  const SectionDeclaration *
  find_section(const std::string &name);

  /** Return the declaration of "Section/Name/Entry"; null if there is none. */
  const EntryDeclaration *
  find_entry(const std::string &full_name);
} // namespace fuga

#endif
