// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_directory_lock_h
#define fuga_output_files_directory_lock_h

#include <filesystem>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * The right to write into a directory of results, which only one run has at a time. The kernel
   * revokes it when the process ends, however it ends: the leftovers of a killed run hinder nobody.
   * On a file system without locks (NFS without its lock service) a warning is printed and nothing
   * is protected. If there are several processes, the first one holds the lock for all.
   */
  class DirectoryLock
  {
  public:
    /**
     * Create the directory if it does not exist, and lock it.
     * @throws InputError if another run has the lock, or the directory cannot be written to.
     */
    explicit DirectoryLock(const std::string &directory);

    /** Release the lock and remove directories that were created for nothing. */
    ~DirectoryLock();

    DirectoryLock(const DirectoryLock &) = delete;
    DirectoryLock &
    operator=(const DirectoryLock &) = delete;

  private:
    void
    acquire();
    /**
     * Open the lock file and acquire the lock; return whether the file is still the one in the
     * directory.
     */
    bool
    take_file();
    [[noreturn]] void
    refuse() const;

    const std::filesystem::path directory;
    const std::filesystem::path path;
    /** Directories that did not exist before, the innermost one first. */
    std::vector<std::filesystem::path> made;
    int descriptor = -1;
  };
} // namespace fuga

#endif
