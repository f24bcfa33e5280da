// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>

#include <csignal>

namespace fuga
{
  namespace
  {
    volatile std::sig_atomic_t received = 0;

    extern "C" void
    note_signal(const int number)
    {
      if (received != 0)
        {
          std::signal(number, SIG_DFL);
          std::raise(number);
        }
      received = number;
    }
  } // namespace

  void
  interruption::listen()
  {
    received = 0;
    for (const int number : {SIGINT, SIGTERM})
      if (std::signal(number, note_signal) == SIG_IGN)
        std::signal(number, SIG_IGN);
  }

  int
  interruption::signal_number()
  {
    return received;
  }

  int
  interruption::exit_code()
  {
    return 128 + received;
  }

  void
  interruption::check(const char *where)
  {
    if (received != 0)
      throw Interrupted("Interrupted " + std::string(where) + ".");
  }
} // namespace fuga
