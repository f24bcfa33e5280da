// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>

namespace fuga
{
  namespace
  {
    /** Return whether @p byte continues a character of UTF-8. */
    bool
    goes_on(const char byte)
    {
      return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
    }
  } // namespace

  std::string
  InputError::shortened(const std::string &message)
  {
    constexpr std::size_t longest = 3000, kept_at_start = 1500, kept_at_end = 1000;
    if (message.size() <= longest)
      return message;
    std::size_t start = kept_at_start, end = message.size() - kept_at_end;
    while (start > 0 && goes_on(message[start]))
      --start;
    while (end < message.size() && goes_on(message[end]))
      ++end;
    return message.substr(0, start) + " [...] " + message.substr(end);
  }
} // namespace fuga
