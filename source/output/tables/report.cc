// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/output/tables/report.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr const char *python = "/usr/bin/python3";

    /** Find the script beside the installed program, or else in the source folder that it was built
     * from. */
    fs::path
    find_script()
    {
      std::error_code error;
      const fs::path program              = fs::read_symlink("/proc/self/exe", error);
      const std::vector<fs::path> folders = {program.parent_path() / FUGA_SCRIPTS_FROM_PROGRAM,
                                             FUGA_SCRIPTS_IN_SOURCE};
      for (const fs::path &folder : folders)
        if (fs::exists(folder / "make_report.py", error))
          return (folder / "make_report.py").lexically_normal();
      throw InputError(fmt::format(
        "The script make_report.py is neither in {} nor in {}. Install the program with "
        "'cmake --install', or keep its source folder where it was built.",
        folders[0].lexically_normal().string(),
        folders[1].string()));
    }
  } // namespace

  int
  make_report(const std::string &directory, const bool quiet)
  {
    std::fflush(stdout); // earlier output comes first
    const std::string script       = find_script().string();
    std::vector<std::string> words = {python, script, directory};
    std::vector<char *> arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (quiet)
      posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process   = 0;
    const int error = posix_spawn(&process, python, &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
      throw InputError(
        fmt::format("The report needs {}, which cannot be started: {}. Type: sudo apt "
                    "install python3",
                    python,
                    std::strerror(error)));
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
      if (errno != EINTR)
        throw NumericalFailure("The end of the script make_report.py was missed.");
    if (!WIFEXITED(status))
      throw NumericalFailure(fmt::format("The script {} was killed.", script));
    return WEXITSTATUS(status);
  }
} // namespace fuga
