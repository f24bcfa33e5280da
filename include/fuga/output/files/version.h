// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_version_h
#define fuga_output_files_version_h

namespace fuga
{
  /** Version of the program; the build system takes it from here. */
  inline constexpr const char *version = "1.0.0";
} // namespace fuga

#endif
