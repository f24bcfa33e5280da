// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/checksum.h>
#include <fuga/output/files/output_files.h>

#include <zlib.h>

namespace fuga
{
  std::uint32_t
  checksum(const std::string_view text, const std::uint32_t so_far)
  {
    return static_cast<std::uint32_t>(
      crc32_z(so_far, reinterpret_cast<const Bytef *>(text.data()), text.size()));
  }

  FileIdentity
  identify_file(const std::string &path)
  {
    const std::string content = read_file(path);
    return {content.size(), checksum(content)};
  }
} // namespace fuga
