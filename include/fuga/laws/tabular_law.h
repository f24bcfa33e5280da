// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_tabular_law_h
#define fuga_laws_tabular_law_h

#include <fuga/laws/nonlinear_law.h>

namespace fuga
{
  /** The way in which the points of a table are connected. */
  enum class TableInterpolation
  {
    /**
     * Cubics with the slopes of Fritsch and Butland (1984), the method known as PCHIP: monotone,
     * with a continuous tangent. A slope at an end of the table that would be below a tenth of that
     * of its interval is raised to it, so that the tangent is positive everywhere.
     */
    monotone_spline,
    /**
     * Straight lines; a parabola rounds every corner over 5 % of the shorter neighbouring interval
     * on both sides, so that the tangent is continuous.
     */
    piecewise_linear
  };

  /**
   * A measured curve: points (w, σ) starting at (0, 0), continued beyond the last one by a line
   * with the slope there.
   */
  class TabularLaw : public NonlinearLaw
  {
  public:
    /** One point of the table. */
    struct Point
    {
      double deformation = 0.;
      double stress      = 0.;
    };

    /**
     * @p table contains at least two points, the first one (0, 0), with both columns strictly
     * increasing.
     */
    TabularLaw(const std::vector<Point> &table, const TableInterpolation interpolation);

    double
    reference_compliance() const override;
    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    double
    deformation_scale() const override;
    double
    data_limit() const override;
    std::vector<double>
    knots() const override;
    std::string
    description() const override;

  private:
    /** For w ≥ begin, σ = y + (w - begin) (d + (w - begin) (c + (w - begin) b)). */
    struct Piece
    {
      double begin, y, d, c, b;
      /** Energy at begin. */
      double stored;
    };

    void
    join_by_spline(const std::vector<Point> &table);
    void
    join_by_lines(const std::vector<Point> &table);
    void
    append(const double begin, const double y, const double d, const double c, const double b);
    const Piece &
    piece_at(const double w) const;

    const TableInterpolation interpolation;
    const std::size_t n_points;
    const Point last;
    /** The pieces of the curve; the last one is the continuation. */
    std::vector<Piece> pieces;
  };
} // namespace fuga

#endif
