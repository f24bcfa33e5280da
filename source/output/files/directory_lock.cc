// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/processes.h>
#include <fuga/output/files/directory_lock.h>
#include <fuga/output/files/output_files.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr const char *lock_file_name = "run.lock";

    /** Return what the lock file tells a second run. */
    std::string
    description_of_this_process()
    {
      std::array<char, 256> host{};
      gethostname(host.data(), host.size() - 1);
      const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
      return fmt::format(
        "process {} on {} since {:%Y-%m-%d %H:%M:%S}", getpid(), host.data(), fmt::localtime(now));
    }
  } // namespace

  DirectoryLock::DirectoryLock(const std::string &output_directory)
    : directory(output_directory), path(directory / lock_file_name)
  {
    if (processes::is_first())
      acquire();
    processes::meet(processes::Place::begin);
  }

  DirectoryLock::~DirectoryLock()
  {
    if (descriptor < 0)
      return;
    std::error_code ignored;
    fs::remove(path, ignored);
    close(descriptor);
    for (const fs::path &empty : made)
      fs::remove(empty, ignored); // fails if it is not empty
  }

  void
  DirectoryLock::acquire()
  {
    for (fs::path missing = directory; !missing.empty() && !fs::exists(missing);
         missing          = missing.parent_path())
      made.push_back(missing);
    make_output_directory(directory.string());
    while (!take_file())
      {
      }
    if (descriptor < 0)
      return;
    const std::string text = description_of_this_process();
    // Success of this matters only to a message.
    if (ftruncate(descriptor, 0) != 0 || write(descriptor, text.data(), text.size()) < 0)
      return;
  }

  // A run that ends removes its file. A run that opened the file just before then holds a lock of
  // nothing.
  bool
  DirectoryLock::take_file()
  {
    descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw InputError(
        fmt::format("The output directory '{}' cannot be written to: {}. Give another one by the "
                    "entry 'Output directory' or --output-dir.",
                    directory.string(),
                    std::strerror(errno)));
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
      {
        const int reason = errno;
        if (reason == EWOULDBLOCK)
          refuse();
        fmt::print(stderr,
                   "Warning: the output directory '{}' cannot be locked ({}): see to it that no "
                   "other run writes there.\n",
                   directory.string(),
                   std::strerror(reason));
        fs::remove(path);
        close(descriptor);
        descriptor = -1;
        return true;
      }
    struct stat opened = {}, there = {};
    if (fstat(descriptor, &opened) == 0 && stat(path.c_str(), &there) == 0 &&
        opened.st_ino == there.st_ino && opened.st_dev == there.st_dev)
      return true;
    close(descriptor);
    return false;
  }

  void
  DirectoryLock::refuse() const
  {
    std::array<char, 512> holder{};
    const bool is_known = read(descriptor, holder.data(), holder.size() - 1) > 0;
    close(descriptor);
    throw InputError(fmt::format(
      "Another run is writing to the output directory '{}'{}{}{}. Nothing was changed. Wait until "
      "it has ended, or give this run a directory of its own by the entry 'Output directory' or "
      "--output-dir.",
      directory.string(),
      is_known ? " (" : "",
      holder.data(),
      is_known ? ")" : ""));
  }
} // namespace fuga
