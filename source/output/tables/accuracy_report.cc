// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/table.h>
#include <fuga/output/tables/accuracy_report.h>

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
    using Round        = AccuracyReport::Round;
    std::size_t number = 0;
    Table<Round> table(
      directory + "/refinement.csv",
      {{"round", "", [&](const Round &) { return number; }},
       {"cells", "", [](const Round &round) { return round.cells; }},
       {"degrees_of_freedom", "", [](const Round &round) { return round.unknowns; }},
       {"contact_elements", "", [](const Round &round) { return round.contact_elements; }},
       {"degrees_of_freedom_compared",
        "",
        [](const Round &round) { return round.unknowns_compared; }},
       {"quantity", "", [&](const Round &) { return report.quantity; }},
       {"target", "", [&](const Round &) { return report.target; }},
       {"estimated_error", "", [](const Round &round) { return round.estimate; }},
       {"seconds", "", [](const Round &round) { return round.seconds; }}});
    for (const Round &round : report.rounds)
      {
        ++number;
        table.add(round);
      }
    table.publish(true);
  }
} // namespace fuga
