// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/process_info.h>

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
  }

  // Field 22 of /proc/self/stat is the start of the process in clock ticks since boot; the name in
  // field 2 may contain blanks, so counting begins behind its closing bracket.
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


  double
  available_memory_in_megabytes()
  {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (double kilobytes = 0.; file >> name >> kilobytes;)
      {
        if (name == "MemAvailable:")
          return kilobytes / kilobytes_per_megabyte;
        std::getline(file, unit);
      }
    return std::numeric_limits<double>::max();
  }
} // namespace fuga
