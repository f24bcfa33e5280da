// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_verdict_name_h
#define fuga_contact_path_verdict_name_h

#include <fuga/contact/path/path_result.h>

#include <string>

namespace fuga
{
  /** Return a verdict in words, as used in summary.json. */
  std::string
  verdict_name(const Verdict verdict);
} // namespace fuga

#endif
