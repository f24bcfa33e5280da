// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_report_h
#define fuga_output_tables_report_h

#include <string>

namespace fuga
{
  /**
   * Write DIRECTORY/report.html and, for a run, report_short.html from the results there, by the
   * Python script make_report.py that is installed or built with this program. The script says on
   * the screen what it wrote, unless @p quiet, or what is wrong.
   * @return the exit code of the script: 0, or 1 if there are no finished results or packages are
   * missing
   * @throws InputError if there is no Python or no script
   * @throws NumericalFailure if the script was killed
   */
  int
  make_report(const std::string &directory, const bool quiet);
} // namespace fuga

#endif
