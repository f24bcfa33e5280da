// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_svg_chart_h
#define fuga_output_files_svg_chart_h

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /** A chart of curves y(x) over x ≥ 0, y ≥ 0, in black on white. */
  struct SvgChart
  {
    using Points = std::vector<std::array<double, 2>>;

    std::string title, subtitle;
    /** Name and unit of an axis. */
    std::array<std::string, 2> x_axis, y_axis;
    /** Ranges from zero on; nothing but the remark is drawn if one of them is 0. */
    double x_max = 0., y_max = 0.;
    Points curve;
    /** Drawn dashed, and its name for the legend. */
    Points dashed;
    std::string dashed_name;
    /** Small circles. */
    Points dots;
    /** Vertical dotted line with a name; not drawn at 0. */
    double x_mark = 0.;
    std::string mark_name;
    /** Text in the middle of an empty chart. */
    std::string remark;
  };

  /** A page with the charts side by side: a complete SVG 1.1 document. */
  std::string
  svg_page(const std::vector<SvgChart> &charts);
} // namespace fuga

#endif
