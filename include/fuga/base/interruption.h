// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_interruption_h
#define fuga_base_interruption_h

#include <stdexcept>
#include <string>

namespace fuga
{
  /**
   * The user asked the program to end (Ctrl-C, SIGTERM). The message is a sentence that says how
   * far the run had come. The exit code of the program is 128 + the number of the signal, as it is
   * for shells.
   */
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The request to end. The signal handler only records it; long computations check for it at
   * points where they can be left in good order. A second signal ends the program at once.
   */
  namespace interruption
  {
    /**
     * Record signals from now on, except for those that the parent process had set to be ignored; a
     * signal that came before is forgotten.
     */
    void
    listen();

    /** Return the number of the signal that came; 0 if none did. */
    int
    signal_number();

    /**
     * Return the exit code of a program that ends because of this signal: 130 after Ctrl-C, 143
     * after SIGTERM.
     */
    int
    exit_code();

    /** Check for a signal. @throws Interrupted("Interrupted {@p where}.") if one came. */
    void
    check(const char *where);
  } // namespace interruption
} // namespace fuga

#endif
