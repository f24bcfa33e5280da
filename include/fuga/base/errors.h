// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_errors_h
#define fuga_base_errors_h

#include <stdexcept>
#include <string>

namespace fuga
{
  /**
   * The user's mistake: something in the parameter file, the mesh or the command line. The message
   * names the file, the line, the entry, its value, what is allowed and what to do; it is printed
   * as it is, and the program ends with exit code 1 before anything was computed or written. Quoted
   * text may be of any length: a part is left out from the middle of a very long message.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message) : std::runtime_error(shortened(message))
    {
    }

  private:
    static std::string
    shortened(const std::string &message);
  };

  /**
   * The computation cannot go on for a numerical reason (not a mechanical one: a loss of
   * equilibrium is a result, see Verdict). Ends the program with exit code 2.
   */
  class NumericalFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The path of the joints cannot be followed any further, although the present state is right and
   * there may be another one beyond it.
   */
  class PathFailure : public NumericalFailure
  {
  public:
    using NumericalFailure::NumericalFailure;
  };

  /**
   * A result file cannot be written: the disk is full or not writable for the user. Everything
   * written before is complete. Ends the program with exit code 5.
   */
  class WriteFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace fuga

#endif
