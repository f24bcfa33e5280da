// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_output_files_h
#define fuga_io_output_files_h

#include <chrono>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Writes a whole file under a temporary name in the same directory and renames it: whoever looks,
   * and whatever kills the program, the file is either the old one or complete.
   * @throws NumericalFailure naming the file and the reason of the system.
   */
  void
  write_complete_file(const std::string &path, const std::string &content);

  /** @throws InputError if the directory is not there and cannot be made. */
  void
  make_output_directory(const std::string &directory);

  /**
   * Removes what an earlier run of this program left, but for the file @p kept: a directory never
   * shows a mixture of two runs.
   */
  void
  remove_earlier_results(const std::string &directory, const std::string &kept);

  /**
   * A CSV file (RFC 4180, numbers with 17 digits) that grows during the run but is complete
   * whenever it can be seen: it is published whole, and not so often that publishing costs more
   * than a small share of the run.
   */
  class CsvFile
  {
  public:
    CsvFile(std::string path, const std::vector<std::string> &header);

    void
    add(const std::string &field);
    void
    add(const double value);
    void
    add(const std::size_t value);
    void
    end_row();

    /** Publishes the rows so far if it is worth it, or in any case if @p now. */
    void
    publish(const bool now);

  private:
    void
    separate();

    const std::string path;
    std::string text;
    bool row_begun   = false;
    bool unpublished = true;
    double last_cost = 0.;
    std::chrono::steady_clock::time_point last_publication;
  };
} // namespace fuga

#endif
