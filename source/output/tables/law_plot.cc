// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/layer_law.h>
#include <fuga/laws/law_check.h>
#include <fuga/output/files/svg_chart.h>
#include <fuga/output/files/table.h>
#include <fuga/output/tables/law_plot.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    constexpr std::size_t n_points = 400;

    /** One law with the range in which it is shown. */
    struct ShownLaw
    {
      LayerDirection direction;
      std::unique_ptr<ComplianceLaw> law;
      /** 0 for a rigid law. */
      double range;
      std::vector<TabularLaw::Point> table;
      /** Its stiffness grows with closure or pressure; the law is that of the unloaded layer. */
      bool grows;
    };

    /** A thousandth of the softest modulus: where a law has no scale of its own. */
    double
    typical_stress(const Parameters &parameters)
    {
      double softest = std::numeric_limits<double>::infinity();
      for (const Material &material : parameters.model.materials)
        softest = std::min(softest, material.young_modulus);
      return 1e-3 * softest;
    }

    std::vector<ShownLaw>
    laws_of(const JointParameters &joint, const Parameters &parameters)
    {
      std::vector<ShownLaw> laws;
      for (const LayerDirection direction : {LayerDirection::normal, LayerDirection::shear})
        {
          const bool normal  = direction == LayerDirection::normal;
          auto law           = make_layer_law(joint, direction, parameters.model.constants);
          const double range = law->kind() == ComplianceKind::rigid
                                 ? 0.
                                 : range_of_interest(*law, typical_stress(parameters));
          const bool tabular = (normal ? joint.normal_law : joint.shear_law) == LayerLaw::tabular;
          const LayerCurve &curve = normal ? joint.normal_curve : joint.shear_curve;
          laws.push_back({direction,
                          std::move(law),
                          range,
                          tabular ? curve.table : std::vector<TabularLaw::Point>(),
                          !normal && joint.shear_growth.kind != ShearGrowth::Kind::none});
        }
      return laws;
    }

    void
    write_table(const std::string &path, const std::vector<ShownLaw> &laws, const Units &units)
    {
      const std::string stress = units.stress(), stiffness = stress + "/" + units.length;
      struct Sample
      {
        const ShownLaw &shown;
        double w;
      };
      Table<Sample> table(
        path,
        {{"direction",
          "",
          [](const Sample &row) {
            return std::string(row.shown.direction == LayerDirection::normal ? "normal" : "shear");
          }},
         {"deformation", units.length, [](const Sample &row) { return row.w; }},
         {"stress", stress, [](const Sample &row) { return row.shown.law->stress(row.w); }},
         {"tangent", stiffness, [](const Sample &row) { return row.shown.law->tangent(row.w); }},
         {"secant", stiffness, [](const Sample &row) { return row.shown.law->secant(row.w); }},
         {"energy", stress + " " + units.length, [](const Sample &row) {
            return row.shown.law->energy(row.w);
          }}});
      for (const ShownLaw &shown : laws)
        for (std::size_t i = 0; i <= n_points && shown.range > 0.; ++i)
          table.add({shown, shown.range * static_cast<double>(i) / static_cast<double>(n_points)});
      table.publish(true);
    }

    SvgChart
    chart_of(const std::string &joint, const ShownLaw &shown, const Units &units)
    {
      const bool normal        = shown.direction == LayerDirection::normal;
      const ComplianceLaw &law = *shown.law;
      SvgChart chart;
      chart.title    = fmt::format("Joint {}, {} direction", joint, normal ? "normal" : "shear");
      chart.subtitle = law.description() + (shown.grows ? ", layer not loaded" : "");
      chart.x_axis   = {{normal ? "closure w" : "elastic shear jump w", units.length}};
      chart.y_axis   = {{normal ? "pressure" : "shear stress", units.stress()}};
      chart.remark   = "no deformation at any stress";
      if (shown.range == 0.)
        return chart;
      const double margin = 1.05;
      const double limit  = law.deformation_limit();
      chart.x_max         = margin * (std::isfinite(limit) ? limit : shown.range);
      chart.y_max         = margin * law.stress(shown.range);
      // Denser towards zero, where a law may bend most.
      for (std::size_t i = 0; i <= n_points; ++i)
        {
          const double s = static_cast<double>(i) / static_cast<double>(n_points);
          const double w = shown.range * s * s;
          chart.curve.push_back({{w, law.stress(w)}});
        }
      if (law.kind() == ComplianceKind::nonlinear)
        {
          const double slope = law.tangent(0.);
          const double end   = std::min(chart.x_max, chart.y_max / slope);
          chart.dashed       = {{{0., 0.}}, {{end, end * slope}}};
          chart.dashed_name  = "tangent at zero";
        }
      for (const TabularLaw::Point &point : shown.table)
        chart.dots.push_back({{point.deformation, point.stress}});
      if (std::isfinite(limit))
        {
          chart.x_mark    = limit;
          chart.mark_name = "limit";
        }
      return chart;
    }
  } // namespace

  std::vector<std::string>
  write_law_plots(const Parameters &parameters)
  {
    const Units &units = parameters.output.units;
    make_output_directory(parameters.output.directory);
    std::vector<std::string> files;
    for (const JointParameters &joint : parameters.joints)
      {
        const std::string &name          = joint.definition.name;
        const std::string stem           = parameters.output.directory + "/law_" + name;
        const std::vector<ShownLaw> laws = laws_of(joint, parameters);
        std::vector<SvgChart> charts;
        for (const ShownLaw &shown : laws)
          charts.push_back(chart_of(name, shown, units));
        write_table(stem + ".csv", laws, units);
        write_complete_file(stem + ".svg", svg_page(charts));
        files.insert(files.end(), {stem + ".csv", stem + ".svg"});
      }
    return files;
  }
} // namespace fuga
