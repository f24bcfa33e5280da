// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_number_pattern_h
#define fuga_io_parameter_number_pattern_h

#include <deal.II/base/patterns.h>

#include <limits>
#include <memory>
#include <string>

namespace fuga
{
  /**
   * A finite number or integer within bounds. Unlike Patterns::Double and Patterns::Integer it
   * knows strict bounds, refuses what follows the number, and can say what is wrong with a text.
   */
  class NumberPattern : public dealii::Patterns::PatternBase
  {
  public:
    enum class Kind
    {
      real,
      integer
    };

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /** @p is_optional: the empty text, which stands for "not given", matches too. */
    NumberPattern(const Kind kind,
                  const double lower,
                  const bool lower_is_allowed,
                  const double upper,
                  const bool upper_is_allowed,
                  const bool is_optional = false);

    bool
    match(const std::string &text) const override;

    /** "a number > 0", "an integer from 1 to 3". */
    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

    /** Why @p text does not match; "" if it does. */
    std::string
    problem(const std::string &text) const;

  private:
    Kind kind;
    double lower;
    bool lower_is_allowed;
    double upper;
    bool upper_is_allowed;
    bool is_optional;
  };
} // namespace fuga

#endif
