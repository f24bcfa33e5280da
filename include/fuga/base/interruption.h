// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_interruption_h
#define fuga_base_interruption_h

#include <stdexcept>
#include <string>

namespace fuga
{
  /**
   * The user asked the program to end (Ctrl-C, SIGTERM). The message is a sentence that says what
   * was reached. The exit code of the program is 128 + the number of the signal, as of shells.
   */
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The wish to end. The handler of the signals only notes it; who does long work looks at it where
   * the work can be left in good order. A second signal ends the program at once.
   */
  namespace interruption
  {
    /** Signals are noted from now on, those that whoever started the program had ignored excepted;
     * one that came before is forgotten. */
    void
    listen();

    /** The signal that came; 0 if none did. */
    int
    signal_number();

    /** Of a program that ends for this signal: 130 after Ctrl-C, 143 after SIGTERM. */
    int
    exit_code();

    /** @throws Interrupted("Interrupted {@p where}.") if a signal came. */
    void
    check(const char *where);
  } // namespace interruption
} // namespace fuga

#endif
