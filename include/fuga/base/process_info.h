// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_process_info_h
#define fuga_base_process_info_h

namespace fuga
{
  /** Seconds since the operating system started this process, in its clock ticks (0.01 s). */
  double
  seconds_since_process_start();

  /** Largest memory of this process so far [MB]. */
  double
  peak_memory_in_megabytes();

  /** Memory that this process can still get without swapping, as the kernel estimates it [MB]. */
  double
  available_memory_in_megabytes();
} // namespace fuga

#endif
