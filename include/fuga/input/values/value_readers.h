// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_values_value_readers_h
#define fuga_input_values_value_readers_h

#include <fuga/input/syntax/parameter_expressions.h>
#include <fuga/input/values/parameter_values.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Return the index of @p name among the @p known names of one section of the file. @p what says
   * what they are, in the singular.
   * @throws InputError at the @p entry of @p section that contains the name, if it is not known.
   */
  unsigned int
  number_of(const std::string &name,
            const std::vector<std::string> &known,
            const std::string &what,
            const ParameterSection &section,
            const AnyEntry &entry);

  /** Fail at the entry if expression_problem() finds a problem in @p expression. */
  void
  check_expression(const ParameterSection &section,
                   const AnyEntry &entry,
                   const std::string &expression,
                   const ExpressionArguments arguments,
                   const std::map<std::string, double> &constants);

  /** Fail at @p one if both entries are given. */
  void
  refuse_both(const ParameterSection &section, const AnyEntry &one, const AnyEntry &other);

  /** Return the numbers of a text such as "1, 2.5"; none if it is not a list of numbers only. */
  std::vector<double>
  read_coordinates(const std::string &text);

  /**
   * Read the table 'a: b; a: b' of an entry, with increasing a. @p form tells how a point is
   * written, for messages. @throws InputError
   */
  std::vector<std::array<double, 2>>
  read_table(const ParameterSection &section, const AnyEntry &entry, const std::string &form);

  /** The value of an entry Point: the name of a point, or the coordinates. */
  struct PointReference
  {
    std::string name;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
  };

  /** Read entry Point of a section. @throws InputError */
  PointReference
  read_point(const ParameterSection &section, const Text &entry, const unsigned int dimension);
} // namespace fuga

#endif
