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
   * Writes a whole file under a temporary name in the same directory and renames it: whoever looks,
   * and whatever kills the program, the file is either the old one or complete. Of several
   * processes only the first one writes.
   * @throws WriteFailure naming the file, the reason of the system and the space that is left.
   */
  void
  write_complete_file(const std::string &path, const std::string &content);

  /** The same, a file of this process. */
  void
  write_piece(const std::string &path, const std::string &content);

  constexpr const char *checkpoint_file_name = "checkpoint.cbor";
  constexpr const char *paraview_script_name = "view_in_paraview.py";

  /** The content of a file. @throws InputError if it cannot be read. */
  std::string
  read_file(const std::string &path);

  /** By the first process. @throws InputError if the directory is not there and cannot be made. */
  void
  make_output_directory(const std::string &directory);

  /**
   * Removes what an earlier run of this program left, but for the files @p kept (and the pieces of
   * a .pvtu file among them): a directory never shows a mixture of two runs. By the first process.
   */
  void
  remove_earlier_results(const std::string &directory, const std::set<std::string> &kept);

  /**
   * Makes room for the results of a run that begins. Wherever it is killed, nothing passes for
   * finished, and nothing can be restarted whose results have begun to go: first the checkpoint
   * goes,
   * then @p write_unfinished_summary replaces the summary, then all else of an earlier run goes.
   */
  void
  begin_results(const std::string &directory,
                const std::function<void()> &write_unfinished_summary);

  /** What a checkpoint keeps of a TextFile: how much of it is on disk, and the text behind that. */
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
   * The text that a file had when it was remembered. What was written behind that does not matter.
   * @throws InputError if the file does not begin with what was published then.
   */
  std::string
  recover_text(const std::string &path, const TextMemory &memory);

  /**
   * A text that grows during the run and whose file is complete whenever it can be seen: it is
   * published whole, and not so often that publishing costs more than a small share of the run.
   * Processes but the first forget it instead.
   */
  class TextFile
  {
  public:
    explicit TextFile(std::string path);

    /** Without its directory. */
    std::string
    name() const;

    void
    append(const std::string &more)
    {
      text += more;
    }

    /** Publishes the text so far if it is worth it, or in any case if @p now. */
    void
    publish(const bool now);

    TextMemory
    memory() const;

    /** Takes the text back that the file had then; not yet published. */
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
