// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_input_errors_h
#define fuga_base_input_errors_h

#include <fuga/base/errors.h>

#include <vector>

namespace fuga
{
  /**
   * The mistakes of one input, collected so that they can be reported at once instead of one per
   * run.
   */
  class InputErrors
  {
  public:
    /**
     * The messages are ordered by the lines of @p file; without it, they stay in the order found.
     */
    explicit InputErrors(std::string file = {});

    /**
     * Return whether @p action ended without an InputError; an InputError that it throws is kept.
     */
    template <typename Action>
    bool
    attempt(const Action &action)
    {
      try
        {
          action();
          return true;
        }
      catch (const InputError &error)
        {
          messages.emplace_back(error.what());
          return false;
        }
    }

    /**
     * Do nothing if there were no errors.
     * @throws InputError: a single one as it is; several ones, up to twenty, one per line, in the
     * order of the lines of the file (those that belong to no line come last), together with their
     * number.
     */
    void
    throw_if_any() const;

    bool
    any() const
    {
      return !messages.empty();
    }

    void
    add(const std::string &message)
    {
      messages.push_back(message);
    }

    const std::vector<std::string> &
    all() const
    {
      return messages;
    }

  private:
    /**
     * Return the line of the file that a message begins with; the largest number if there is none.
     */
    unsigned long
    line_of(const std::string &message) const;

    const std::string file;
    std::vector<std::string> messages;
  };
} // namespace fuga

#endif
