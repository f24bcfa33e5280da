// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_process_info_h
#define fuga_base_process_info_h

#include <string>

namespace fuga
{
  /**
   * Return the seconds since the operating system started this process, in its clock ticks (0.01
   * s).
   */
  double
  seconds_since_process_start();

  /** Return the peak memory of this process so far [MB]. */
  double
  peak_memory_in_megabytes();

  /**
   * Return the memory that this machine can give to the program [MB]: its physical memory, or less
   * where a control group (container, batch system) limits it; infinity if the system reports
   * neither. The present use by other programs does not matter. @p root is the directory below
   * which /proc and /sys are looked for.
   */
  double
  machine_memory_in_megabytes(const std::string &root = "");
} // namespace fuga

#endif
