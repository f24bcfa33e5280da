// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_output_files_h
#define fuga_output_files_output_files_h

#include <fuga/output/files/checksum.h>
#include <functional>

#include <chrono>
#include <set>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Write a whole file under a temporary name in the same directory and rename it: at any time,
   * whatever kills the program, the file is either the old one or complete. If there are several
   * processes, only the first one writes.
   * @throws WriteFailure naming the file, the reason of the system and the space that is left.
   */
  void
  write_complete_file(const std::string &path, const std::string &content);

  /** Write a file in the same way, but by every process that calls this function. */
  void
  write_piece(const std::string &path, const std::string &content);

  constexpr const char *checkpoint_file_name = "checkpoint.cbor";
  constexpr const char *paraview_script_name = "view_in_paraview.py";

  /** Return the content of a file. @throws InputError if it cannot be read. */
  std::string
  read_file(const std::string &path);

  /**
   * Create the output directory, on the first process. @throws InputError if the directory does not
   * exist and cannot be created.
   */
  void
  make_output_directory(const std::string &directory);

  /**
   * Remove what an earlier run of this program left, except for the files in @p kept (and the
   * pieces of a .pvtu file among them), so that a directory never shows a mixture of two runs. This
   * is done by the first process.
   */
  void
  remove_earlier_results(const std::string &directory, const std::set<std::string> &kept);

  /**
   * Make room for the results of a run that begins. Wherever the program is killed, nothing looks
   * finished, and no run can be restarted whose results are partly removed: first the checkpoint is
   * removed, then @p write_unfinished_summary replaces the summary, then everything else of an
   * earlier run is removed.
   */
  void
  begin_results(const std::string &directory,
                const std::function<void()> &write_unfinished_summary);

  /**
   * The state of a TextFile in a checkpoint: how much of it is on disk, and the text after that.
   */
  struct TextMemory
  {
    FileIdentity published;
    std::string rest;
  };

  template <typename Memory, typename Visitor, only_for<Memory, TextMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[published, rest] = memory;
    visit("published", published);
    visit("rest", rest);
  }

  /**
   * Return the text that a file had when @p memory was stored. Anything written after that is
   * ignored.
   * @throws InputError if the file does not begin with what was published then.
   */
  std::string
  recover_text(const std::string &path, const TextMemory &memory);

  /**
   * A text that grows during the run and whose file is complete whenever it can be seen: it is
   * published whole, and not so often that publishing costs more than a small share of the run. All
   * processes except for the first one discard it instead.
   */
  class TextFile
  {
  public:
    explicit TextFile(std::string path);

    /** Return the name of the file without its directory. */
    std::string
    name() const;

    void
    append(const std::string &more)
    {
      text += more;
    }

    /** Publish the text so far if it is worthwhile, or in any case if @p now is true. */
    void
    publish(const bool now);

    TextMemory
    memory() const;

    /** Restore the text that the file had when @p memory was stored; it is not yet published. */
    void
    restore(const TextMemory &memory);

  private:
    std::string text;
    const std::string path;
    FileIdentity published;
    double last_cost = 0.;
    std::chrono::steady_clock::time_point last_publication;
  };
} // namespace fuga

#endif
