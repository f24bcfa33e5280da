// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/process_info.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace fuga
{
  namespace
  {
    constexpr double kilobytes_per_megabyte = 1024.;
    constexpr double bytes_per_megabyte     = 1024. * 1024.;
  } // namespace

  // Field 22 of /proc/self/stat is the start of the process in clock ticks since boot. The name in
  // field 2 may contain blanks, so counting begins after its closing bracket.
  double
  seconds_since_process_start()
  {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string text;
    std::getline(stat, text);
    double up = 0.;
    if (!(uptime >> up) || text.rfind(')') == std::string::npos)
      return 0.;
    std::istringstream rest(text.substr(text.rfind(')') + 2));
    std::string field;
    for (int i = 3; i <= 21; ++i)
      rest >> field;
    double ticks = 0.;
    if (!(rest >> ticks))
      return 0.;
    return up - ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
  }

  double
  peak_memory_in_megabytes()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / kilobytes_per_megabyte;
  }


  namespace
  {
    /** Return the number that a file begins with; infinity if there is none ("max"). */
    double
    number_in(const std::string &path)
    {
      std::ifstream file(path);
      double value = 0.;
      return file >> value ? value : std::numeric_limits<double>::infinity();
    }

    double
    physical_megabytes(const std::string &root)
    {
      std::ifstream file(root + "/proc/meminfo");
      std::string name, unit;
      for (double kilobytes = 0.; file >> name >> kilobytes; std::getline(file, unit))
        if (name == "MemTotal:")
          return kilobytes / kilobytes_per_megabyte;
      return std::numeric_limits<double>::infinity();
    }
  } // namespace

  // A line of /proc/self/cgroup is number:controllers:path. Each group up to the root may have a
  // limit; in a container the path may be that of the host, so that only the root is found.
  double
  machine_memory_in_megabytes(const std::string &root)
  {
    double result = physical_megabytes(root);
    std::ifstream groups(root + "/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);)
      {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos)
          continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (!controllers.empty() && controllers != "memory")
          continue;
        const std::string top  = root + "/sys/fs/cgroup" + (controllers.empty() ? "" : "/memory");
        const std::string file = controllers.empty() ? "/memory.max" : "/memory.limit_in_bytes";
        for (std::string group = line.substr(second + 1);; group.resize(group.rfind('/')))
          {
            result = std::min(result, number_in(top + group + file) / bytes_per_megabyte);
            if (group.find('/') == std::string::npos)
              break;
          }
      }
    return result;
  }
} // namespace fuga
