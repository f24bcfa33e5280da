// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/verdict_name.h>

namespace fuga
{
  std::string
  verdict_name(const Verdict verdict)
  {
    switch (verdict)
      {
        case Verdict::done:
          return "done";
        case Verdict::limit_load:
          return "limit load";
        case Verdict::no_continuation:
          return "no continuation";
        case Verdict::non_unique_continuation:
          return "non-unique continuation";
      }
    return "";
  }
} // namespace fuga
