// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_checksum_h
#define fuga_output_files_checksum_h

#include <fuga/base/fields.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace fuga
{
  /**
   * Return the CRC-32 of @p text, or of a longer text that ends with it and whose beginning has the
   * checksum @p so_far.
   */
  std::uint32_t
  checksum(const std::string_view text, const std::uint32_t so_far = 0);

  /** Size and checksum, by which a file that has changed is recognised. */
  struct FileIdentity
  {
    std::size_t size       = 0;
    std::uint32_t checksum = 0;

    bool
    operator==(const FileIdentity &other) const
    {
      return size == other.size && checksum == other.checksum;
    }
  };

  template <typename Identity, typename Visitor, only_for<Identity, FileIdentity> = 0>
  void
  for_each_field(Identity &identity, Visitor &&visit)
  {
    auto &[size, sum] = identity;
    visit("size", size);
    visit("checksum", sum);
  }

  /** Return the identity of a file. @throws InputError if the file cannot be read. */
  FileIdentity
  identify_file(const std::string &path);
} // namespace fuga

#endif
