// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/svg_chart.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Sizes in pixels: one chart, and its frame within it. */
    constexpr double width = 480., height = 400.;
    constexpr double left = 70., right = 455., top = 70., bottom = 340.;
    constexpr double tick_length = 5.;
    constexpr int n_ticks        = 5;

    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
      return result;
    }

    /** What fits above one chart. */
    std::string
    shortened(const std::string &text)
    {
      const std::size_t longest = 66;
      return escaped(text.size() <= longest ? text : text.substr(0, longest - 3) + "...");
    }

    std::string
    text(const double x,
         const double y,
         const std::string &content,
         const std::string &anchor,
         const std::string &extra = "")
    {
      return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n",
                         x,
                         y,
                         anchor,
                         extra,
                         content);
    }

    std::string
    line(
      const double x0, const double y0, const double x1, const double y1, const std::string &style)
    {
      return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n",
                         x0,
                         y0,
                         x1,
                         y1,
                         style);
    }

    /** One axis: where values lie on the page, its ticks, and the power of ten in its label. */
    struct Axis
    {
      Axis(const double largest, const double page_begin, const double page_end)
        : max(largest), begin(page_begin), end(page_end)
      {
        const double raw   = max / n_ticks;
        const double power = std::pow(10., std::floor(std::log10(raw)));
        const double share = raw / power;
        step               = power * (share < 1.5 ? 1. : share < 3.5 ? 2. : share < 7.5 ? 5. : 10.);
        const int digits   = static_cast<int>(std::floor(std::log10(max)));
        if (digits < -1 || digits > 3)
          exponent = 3 * static_cast<int>(std::floor((digits + 1) / 3.));
      }

      double
      place(const double value) const
      {
        return begin + (end - begin) * value / max;
      }

      std::string
      number(const double value) const
      {
        return fmt::format("{:.6g}", value / std::pow(10., exponent));
      }

      std::string
      label(const std::array<std::string, 2> &name_and_unit) const
      {
        const std::string factor = exponent == 0
                                     ? ""
                                     : fmt::format("10<tspan dy=\"-4\" font-size=\"9\">{}</tspan>"
                                                   "<tspan dy=\"4\"> </tspan>",
                                                   exponent);
        return fmt::format(
          "{} [{}{}]", escaped(name_and_unit[0]), factor, escaped(name_and_unit[1]));
      }

      const double max, begin, end;
      double step  = 1.;
      int exponent = 0;
    };

    std::string
    axes(const SvgChart &chart, const Axis &x, const Axis &y)
    {
      const std::string grid = "stroke=\"#cccccc\" stroke-width=\"0.7\"";
      const std::string tick = "stroke=\"black\"";
      std::string result;
      for (int i = 0; i * x.step <= x.max * (1. + 1e-9); ++i)
        {
          const double at = x.place(i * x.step);
          result += line(at, top, at, bottom, grid);
          result += line(at, bottom, at, bottom + tick_length, tick);
          result += text(at, bottom + 18., x.number(i * x.step), "middle");
        }
      for (int i = 0; i * y.step <= y.max * (1. + 1e-9); ++i)
        {
          const double at = y.place(i * y.step);
          result += line(left, at, right, at, grid);
          result += line(left - tick_length, at, left, at, tick);
          result += text(left - 8., at + 4., y.number(i * y.step), "end");
        }
      result += text(0.5 * (left + right), bottom + 42., x.label(chart.x_axis), "middle");
      const double middle = 0.5 * (top + bottom), side = 20.;
      result += text(side,
                     middle,
                     y.label(chart.y_axis),
                     "middle",
                     fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", side, middle));
      return result;
    }

    std::string
    polyline(const SvgChart::Points &points, const Axis &x, const Axis &y, const std::string &style)
    {
      std::string result = "<polyline fill=\"none\" stroke=\"black\" " + style + " points=\"";
      for (const auto &[a, b] : points)
        result += fmt::format("{:.2f},{:.2f} ", x.place(a), y.place(b));
      return result + "\"/>\n";
    }

    const std::string dashes = "stroke-width=\"1.2\" stroke-dasharray=\"7 4\"";

    /** At the upper left below a curve that bends upwards, else at the lower right. */
    std::string
    legend(const SvgChart &chart)
    {
      const auto &end      = chart.curve.back();
      const auto &line_end = chart.dashed.back();
      const bool above     = end[1] * line_end[0] > line_end[1] * end[0];
      const double x0      = above ? left + 10. : right - 145.;
      const double y0      = above ? top + 8. : bottom - 28.;
      return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"135\" height=\"20\" "
                         "fill=\"white\"/>\n",
                         x0,
                         y0) +
             line(x0 + 4., y0 + 10., x0 + 32., y0 + 10., "stroke=\"black\" " + dashes) +
             text(x0 + 38., y0 + 14., escaped(chart.dashed_name), "start");
    }

    std::string
    content(const SvgChart &chart)
    {
      const Axis x(chart.x_max, left, right), y(chart.y_max, bottom, top);
      std::string result = axes(chart, x, y);
      if (chart.x_mark > 0.)
        {
          const double at = x.place(chart.x_mark);
          result += line(
            at, top, at, bottom, "stroke=\"black\" stroke-width=\"1.2\" stroke-dasharray=\"2 3\"");
          result +=
            text(at - 5.,
                 top + 12.,
                 escaped(chart.mark_name),
                 "end",
                 fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", at - 5., top + 12.));
        }
      if (!chart.dashed.empty())
        result += polyline(chart.dashed, x, y, dashes) + legend(chart);
      result += polyline(chart.curve, x, y, "stroke-width=\"2\"");
      for (const auto &[a, b] : chart.dots)
        result += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"white\" "
                              "stroke=\"black\" stroke-width=\"1.2\"/>\n",
                              x.place(a),
                              y.place(b));
      return result;
    }
  } // namespace

  std::string
  svg_page(const std::vector<SvgChart> &charts)
  {
    const double total = width * static_cast<double>(charts.size());
    std::string page   = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                     "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
                                     "width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
                                     "font-family=\"sans-serif\" font-size=\"12\">\n"
                                     "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n",
                                   total,
                                   height);
    for (std::size_t i = 0; i < charts.size(); ++i)
      {
        const SvgChart &chart = charts[i];
        page +=
          fmt::format("<g transform=\"translate({:g} 0)\">\n", width * static_cast<double>(i));
        page +=
          text(left, 28., escaped(chart.title), "start", " font-size=\"15\" font-weight=\"bold\"");
        page += text(left, 50., shortened(chart.subtitle), "start");
        if (chart.x_max > 0. && chart.y_max > 0.)
          page += content(chart);
        else
          page += text(0.5 * (left + right), 0.5 * (top + bottom), escaped(chart.remark), "middle");
        page += fmt::format("<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" "
                            "fill=\"none\" stroke=\"black\"/>\n</g>\n",
                            left,
                            top,
                            right - left,
                            bottom - top);
      }
    return page + "</svg>\n";
  }
} // namespace fuga
