// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/accuracy_report.h>
#include <fuga/io/output_files.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    std::string
    percent(const double error)
    {
      return std::isnan(error) ? "not known" : fmt::format("{:.3g} %", 100. * error);
    }
  } // namespace


  std::string
  AccuracyReport::description(const std::size_t number) const
  {
    const Round &round = rounds[number];
    return fmt::format(
      "Mesh {:>3}: {:>8} degrees of freedom, {:>5} contact elements; estimated error of "
      "the {} {}",
      number + 1,
      round.unknowns,
      round.contact_elements,
      quantity,
      percent(round.estimate));
  }


  std::string
  AccuracyReport::conclusion() const
  {
    return fmt::format("estimated error of the {} {}, target {}: {}{}",
                       quantity,
                       percent(rounds.back().estimate),
                       percent(target),
                       reached ? "" : "NOT reached, ",
                       end);
  }


  void
  write_refinement_table(const std::string &directory, const AccuracyReport &report)
  {
    CsvFile table(directory + "/refinement.csv",
                  {"round",
                   "cells",
                   "degrees_of_freedom",
                   "contact_elements",
                   "degrees_of_freedom_compared",
                   "quantity",
                   "target",
                   "estimated_error",
                   "seconds"});
    for (std::size_t i = 0; i < report.rounds.size(); ++i)
      {
        const AccuracyReport::Round &round = report.rounds[i];
        for (const std::size_t number :
             {i + 1, round.cells, round.unknowns, round.contact_elements, round.unknowns_compared})
          table.add(number);
        table.add(report.quantity);
        for (const double value : {report.target, round.estimate, round.seconds})
          table.add(value);
        table.end_row();
      }
    table.publish(true);
  }
} // namespace fuga
