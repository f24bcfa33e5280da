// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_cut_polygon_h
#define fuga_tests_stress_cut_polygon_h

#include "stress/parts_of_bodies.h"
#include "stress/scene_data.h"

#include <array>

namespace fuga::stress
{
  /**
   * A polygon that straight lines cut into bodies, of triangles. Lines may cut all bodies or some,
   * so that joints cross, meet in T or end at the outline. Edges at the outside of a body belong to
   * the group BODY_sK with the number K of the side of the polygon; where two bodies meet is the
   * line BODY-BODY, lower number first.
   */
  class CutPolygon : public SceneData
  {
  public:
    using Point = std::array<double, 2>;

    /** @p outline: corners in counterclockwise order. If the polygon is not @p convex, the origin must
     * see all of them. */
    CutPolygon(const std::vector<Point> &outline, const bool convex);

    std::size_t
    n_bodies() const;

    /** Cuts the bodies with a flag in @p which along the line normal . x = offset. Nothing happens,
     * and the answer is false, if this would leave an edge below the share @p smallest of the
     * polygon's width, or a convex part below its square. */
    bool
    cut(const Point &normal,
        const double offset,
        const std::vector<bool> &which,
        const double smallest);

    /** Makes triangles of the convex parts, around their centres; each is then cut into four
     * @p n_refinements times. */
    void
    triangulate(const unsigned int n_refinements);

    /** Groups of edges at the outside, with the mean outward normal of each. */
    std::map<std::string, Point>
    outer_groups() const;

    unsigned int
    dimension() const override
    {
      return 2;
    }

    std::string
    cells() const override
    {
      return "unstructured triangles";
    }

    double
    size_ratio() const override
    {
      return aspect_of(lengths());
    }

    std::string
    mesh_text() const override;
    double
    width() const override;
    double
    largest_aspect() const override;
    double
    offset() const override;

  private:
    /** Convex, counterclockwise; corners where another part begins are listed though the edge goes
     * straight on. */
    struct Part
    {
      std::size_t body = 0;
      std::vector<std::size_t> corners;
    };

    std::vector<Point> vertices;
    std::vector<Part> parts;
    /** Numbers of the polygon's sides. */
    std::map<Edge, std::size_t> sides;

    FaceGroups
    faces() const override;
    std::size_t
    divide(const Edge &at, const Point &place);
    void
    split(const Point &normal, const double offset, const std::vector<bool> &which);
    void
    number_bodies();
    std::vector<double>
    lengths() const;
    double
    area(const Part &part) const;
  };
} // namespace fuga::stress

#endif
