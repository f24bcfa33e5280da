// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/work_counter.h>
#include <fuga/bodies/processes.h>
#include <fuga/output/files/output_files.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    amount(const double n_bytes)
    {
      return n_bytes < 1e6 ? fmt::format("{:.1f} kB", n_bytes / 1e3)
                           : fmt::format("{:.1f} MB", n_bytes / 1e6);
    }

    /** Remove the incomplete file and throw: on a full disk others need the room. */
    [[noreturn]] void
    fail_to_write(const std::string &path, const std::size_t size, const int reason)
    {
      std::error_code ignored;
      fs::remove(path + ".part", ignored);
      const fs::path directory   = fs::absolute(path).parent_path();
      const fs::space_info space = fs::space(directory, ignored);
      const bool is_full         = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
      throw WriteFailure(fmt::format(
        "The result file {} ({}) cannot be written: {}. {} free in {}. {}",
        path,
        amount(static_cast<double>(size)),
        std::strerror(reason),
        ignored ? "It is not known how much is"
                : amount(static_cast<double>(space.available)) + " are",
        directory.string(),
        is_full ? "Make room there (or ask for a larger quota or limit of the size of files), "
                  "or write less: Output/Fields = end, fewer levels."
                : "Look whether the directory is still there and whether you may write to it."));
    }
  } // namespace

  namespace
  {
    // The number of times that a table is published while it grows depends on the clock, so every
    // file is counted in its last form only. A checkpoint is not counted at all, because it
    // contains what is not published yet.
    void
    count_bytes(const std::string &path, const std::size_t size)
    {
      if (std::filesystem::path(path).filename() == checkpoint_file_name)
        return;
      static std::map<std::string, std::size_t> sizes;
      std::size_t &counted = sizes[path];
      work::now().bytes_written += size;
      work::now().bytes_written -= counted;
      counted = size;
    }
  } // namespace

  void
  write_complete_file(const std::string &path, const std::string &content)
  {
    if (processes::is_first())
      write_piece(path, content);
  }

  void
  write_piece(const std::string &path, const std::string &content)
  {
    const work::Scope phase(work::Phase::results);
    count_bytes(path, content.size());
    const std::string temporary = path + ".part";
    errno                       = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file || std::rename(temporary.c_str(), path.c_str()) != 0)
      fail_to_write(path, content.size(), errno);
  }

  std::string
  read_file(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::string content(file ? static_cast<std::size_t>(file.tellg()) : 0, ' ');
    file.seekg(0);
    if (!file.read(content.data(), static_cast<std::streamsize>(content.size())))
      throw InputError(fmt::format("The file {} cannot be read: {}.", path, std::strerror(errno)));
    return content;
  }

  namespace
  {
    bool
    ends_with(const std::string &name, const std::string &end)
    {
      return name.size() > end.size() &&
             name.compare(name.size() - end.size(), std::string::npos, end) == 0;
    }

    /** Return whether a file in a result directory was written by an earlier run of this
     * program. */
    bool
    is_own_file(const std::string &name)
    {
      for (const char *known : {"events.csv",
                                "joint_history.csv",
                                "resultants.csv",
                                "monitors.csv",
                                "earthquake.csv",
                                "accelerations.csv",
                                "spectra.csv",
                                "summary.json",
                                "sweep.csv",
                                "refinement.csv",
                                "boundaries.csv",
                                "report.html",
                                "report_short.html",
                                paraview_script_name,
                                "log.txt",
                                checkpoint_file_name})
        if (name == known)
          return true;
      for (const char *prefix : {"bodies", "joints", "joints_exploded"})
        if (name.rfind(prefix, 0) == 0 && (name == std::string(prefix) + ".pvd" ||
                                           ends_with(name, ".vtu") || ends_with(name, ".pvtu")))
          return true;
      return ends_with(name, ".part");
    }

    /** Return whether a file is kept. The pieces "x.0.vtu", "x.1.vtu" ... are kept with the record
     * "x.pvtu" that names them. */
    bool
    is_kept(const std::string &name, const std::set<std::string> &kept)
    {
      return kept.count(name) > 0 ||
             (ends_with(name, ".vtu") && kept.count(name.substr(0, name.find('.')) + ".pvtu") > 0);
    }
  } // namespace

  void
  make_output_directory(const std::string &directory)
  {
    if (!processes::is_first())
      return;
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
      throw InputError(
        fmt::format("The output directory '{}' cannot be made: {}. Give another one by "
                    "the entry 'Output directory' or --output-dir.",
                    directory,
                    error.message()));
  }

  void
  remove_earlier_results(const std::string &directory, const std::set<std::string> &kept)
  {
    if (!processes::is_first())
      return;
    // Collections and checkpoint come first, because they must not name a file that is gone.
    for (const bool references : {true, false})
      for (const auto &entry : fs::directory_iterator(directory))
        {
          const std::string name = entry.path().filename().string();
          if (entry.is_regular_file() && !is_kept(name, kept) && is_own_file(name) &&
              (!references || entry.path().extension() == ".pvd" || name == checkpoint_file_name))
            fs::remove(entry.path());
        }
  }

  void
  begin_results(const std::string &directory, const std::function<void()> &write_unfinished_summary)
  {
    make_output_directory(directory);
    if (processes::is_first())
      fs::remove(fs::path(directory) / checkpoint_file_name);
    write_unfinished_summary();
    remove_earlier_results(directory, {"summary.json"});
  }

  std::string
  recover_text(const std::string &path, const TextMemory &memory)
  {
    std::string text = read_file(path);
    text.resize(std::min(text.size(), memory.published.size));
    if (text.size() != memory.published.size || checksum(text) != memory.published.checksum)
      throw InputError(fmt::format("{} is not as the run left it that is to be restarted.", path));
    return text + memory.rest;
  }

  TextFile::TextFile(std::string file_path) : path(std::move(file_path))
  {
  }

  std::string
  TextFile::name() const
  {
    return fs::path(path).filename().string();
  }

  void
  TextFile::publish(const bool now)
  {
    if (!processes::is_first())
      {
        text.clear();
        return;
      }
    using seconds             = std::chrono::duration<double>;
    const double cost_divisor = 20.;
    const auto begin          = std::chrono::steady_clock::now();
    if (text.size() == published.size ||
        (!now && seconds(begin - last_publication).count() < cost_divisor * last_cost))
      return;
    write_complete_file(path, text);
    const auto news    = std::string_view(text).substr(published.size);
    published.checksum = checksum(news, published.checksum);
    published.size     = text.size();
    last_publication   = std::chrono::steady_clock::now();
    last_cost          = seconds(last_publication - begin).count();
  }

  TextMemory
  TextFile::memory() const
  {
    return {published, text.substr(published.size)};
  }

  void
  TextFile::restore(const TextMemory &memory)
  {
    if (processes::is_first())
      text = recover_text(path, memory);
    published = {};
  }
} // namespace fuga
