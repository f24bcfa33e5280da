// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_entries_h
#define fuga_io_parameter_entries_h

#include <fuga/io/parameter_declarations.h>

namespace fuga
{
  /** The words in which the tables of entries are written. */
  namespace parameter_entries
  {
    using Pattern = std::shared_ptr<const dealii::Patterns::PatternBase>;

    Pattern
    text();

    Pattern
    choice(const std::string &words);

    Pattern
    integer(const double lower, const double upper);

    Pattern
    any_number();

    Pattern
    number_above(const double lower);

    Pattern
    number_from(const double lower);

    Pattern
    number_between(const double lower, const bool lower_is_allowed, const double upper);

    /** Both bounds are allowed. */
    Pattern
    number_in(const double lower, const double upper);

    EntryDeclaration
    required(const std::string &name,
             const Pattern &pattern,
             const std::string &documentation,
             const std::vector<std::string> &examples);

    EntryDeclaration
    optional(const std::string &name,
             const Pattern &pattern,
             const std::string &documentation,
             const std::vector<std::string> &examples = {});

    EntryDeclaration
    defaulted(const std::string &name,
              const std::string &default_value,
              const Pattern &pattern,
              const std::string &documentation,
              const std::vector<std::string> &examples = {});

    /** Law and curve of a joint's layer in both directions. */
    std::vector<EntryDeclaration>
    layer_entries();
    /** Entries of a joint. */
    std::vector<EntryDeclaration>
    joint_strength_entries();
    std::vector<EntryDeclaration>
    joint_shear_growth_entries();

    /** Entries of loads by water, earth and earthquakes. */
    std::vector<EntryDeclaration>
    load_depth_and_shaking();
    std::vector<EntryDeclaration>
    load_uplift();

    /** Sections that say how to run, not what. */
    SectionDeclaration
    solver_section();
    SectionDeclaration
    safety_section();
    SectionDeclaration
    sweep_section();
    SectionDeclaration
    accuracy_section();
    SectionDeclaration
    monitors_section();
    SectionDeclaration
    output_section();
  } // namespace parameter_entries
} // namespace fuga

#endif
