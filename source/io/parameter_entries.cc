// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>
#include <fuga/io/parameter_number_pattern.h>

namespace fuga
{
  namespace parameter_entries
  {
    Pattern
    text()
    {
      return std::make_shared<dealii::Patterns::Anything>();
    }

    Pattern
    choice(const std::string &words)
    {
      return std::make_shared<dealii::Patterns::Selection>(words);
    }

    Pattern
    integer(const double lower, const double upper)
    {
      return std::make_shared<NumberPattern>(
        NumberPattern::Kind::integer, lower, true, upper, true, false);
    }

    Pattern
    any_number()
    {
      return std::make_shared<NumberPattern>(NumberPattern::Kind::real,
                                             -NumberPattern::infinity,
                                             false,
                                             NumberPattern::infinity,
                                             false,
                                             true);
    }

    Pattern
    number_above(const double lower)
    {
      return std::make_shared<NumberPattern>(
        NumberPattern::Kind::real, lower, false, NumberPattern::infinity, false, true);
    }

    Pattern
    number_from(const double lower)
    {
      return std::make_shared<NumberPattern>(
        NumberPattern::Kind::real, lower, true, NumberPattern::infinity, false, true);
    }

    Pattern
    number_between(const double lower, const bool lower_is_allowed, const double upper)
    {
      return std::make_shared<NumberPattern>(
        NumberPattern::Kind::real, lower, lower_is_allowed, upper, false, true);
    }

    Pattern
    number_in(const double lower, const double upper)
    {
      return std::make_shared<NumberPattern>(
        NumberPattern::Kind::real, lower, true, upper, true, true);
    }

    EntryDeclaration
    required(const std::string &name,
             const Pattern &pattern,
             const std::string &documentation,
             const std::vector<std::string> &examples)
    {
      return {name, Presence::required, "", pattern, documentation, examples, false};
    }

    EntryDeclaration
    optional(const std::string &name,
             const Pattern &pattern,
             const std::string &documentation,
             const std::vector<std::string> &examples)
    {
      return {name, Presence::optional, "", pattern, documentation, examples, false};
    }

    EntryDeclaration
    defaulted(const std::string &name,
              const std::string &default_value,
              const Pattern &pattern,
              const std::string &documentation,
              const std::vector<std::string> &examples)
    {
      return {name,
              Presence::defaulted,
              default_value,
              pattern,
              documentation,
              examples,
              default_value.empty()};
    }
  } // namespace parameter_entries
} // namespace fuga
