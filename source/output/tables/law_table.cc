// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/layer_law.h>
#include <fuga/laws/law_check.h>
#include <fuga/output/files/table.h>
#include <fuga/output/tables/law_table.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    constexpr std::size_t n_intervals = 400;

    /** A law at one deformation. */
    struct LawRow
    {
      LayerDirection direction;
      const ComplianceLaw &law;
      double w;
    };

    template <double (ComplianceLaw::*quantity)(double) const>
    TableField
    at_deformation(const LawRow &row)
    {
      return (row.law.*quantity)(row.w);
    }

    Columns<LawRow>
    law_columns(const Units &u)
    {
      const std::string stiffness = u.stress() + "/" + u.length;
      return {{"direction",
               "",
               [](const LawRow &row) {
                 return std::string(row.direction == LayerDirection::normal ? "normal" : "shear");
               }},
              {"deformation", u.length, [](const LawRow &row) { return row.w; }},
              {"stress", u.stress(), at_deformation<&ComplianceLaw::stress>},
              {"tangent", stiffness, at_deformation<&ComplianceLaw::tangent>},
              {"secant", stiffness, at_deformation<&ComplianceLaw::secant>},
              {"energy", u.stress() + " " + u.length, at_deformation<&ComplianceLaw::energy>},
              {"limit", u.length, [](const LawRow &row) { return row.law.deformation_limit(); }}};
    }

    /** Return a thousandth of the softest modulus, for laws that have no scale of their own. */
    double
    typical_stress(const Parameters &parameters)
    {
      double softest = std::numeric_limits<double>::infinity();
      for (const Material &material : parameters.model.materials)
        softest = std::min(softest, material.young_modulus);
      return 1e-3 * softest;
    }
  } // namespace

  std::vector<std::string>
  write_law_tables(const Parameters &parameters)
  {
    make_output_directory(parameters.output.directory);
    std::vector<std::string> files;
    for (const JointParameters &joint : parameters.joints)
      {
        files.push_back(parameters.output.directory + "/law_" + joint.definition.name + ".csv");
        Table<LawRow> table(files.back(), law_columns(parameters.output.units));
        for (const LayerDirection direction : {LayerDirection::normal, LayerDirection::shear})
          {
            const auto law = make_layer_law(joint, direction, parameters.model.constants);
            if (law->kind() == ComplianceKind::rigid)
              continue;
            const double range = range_of_interest(*law, typical_stress(parameters));
            for (std::size_t i = 0; i <= n_intervals; ++i)
              table.add({direction,
                         *law,
                         range * static_cast<double>(i) / static_cast<double>(n_intervals)});
          }
        table.publish(true);
      }
    return files;
  }
} // namespace fuga
