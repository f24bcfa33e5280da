// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_cut_polyhedron_h
#define fuga_tests_stress_cut_polyhedron_h

#include "stress/parts_of_bodies.h"
#include "stress/scene_data.h"

#include <array>

namespace fuga::stress
{
  /**
   * A convex polyhedron that planes cut into bodies, of tetrahedra: what CutPolygon is in the
   * plane. Planes may cut all bodies or some, so that joints cross, meet in T or end at the
   * outside. Faces at the outside of a body belong to the group BODY_sK with the number K of the
   * side of the polyhedron; where two bodies meet is BODY-BODY, lower number first.
   */
  class CutPolyhedron : public SceneData
  {
  public:
    using Point = std::array<double, 3>;

    /** A box around the origin, @p half its sides; its own sides have the numbers 0 to 5. */
    explicit CutPolyhedron(const Point &half);

    /** Removes what lies beyond normal . x = offset: one more side. Nothing happens, and the answer
     * is false, as in cut(). */
    bool
    cut_off(const Point &normal, const double offset, const double smallest);

    /** Cuts the bodies with a flag in @p which along the plane normal . x = offset. Nothing happens,
     * and the answer is false, if the plane meets none of them or would leave an edge, or the
     * distance of a convex part's centre from its faces, below the share @p smallest of the width.
     */
    bool
    cut(const Point &normal,
        const double offset,
        const std::vector<bool> &which,
        const double smallest);

    /** Makes tetrahedra of the convex parts, around their centres and those of their faces. */
    void
    make_tetrahedra();

    std::size_t
    n_bodies() const;

    /** Groups of faces at the outside, with the outward normal of each. */
    std::map<std::string, Point>
    outer_groups() const;

    unsigned int
    dimension() const override
    {
      return 3;
    }

    std::string
    cells() const override
    {
      return "unstructured tetrahedra";
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
    /** Plane and convex; its corners go round. Vertices of others on its edges are corners. */
    struct Face
    {
      std::vector<std::size_t> corners;
      /** Of the polyhedron, or `inside`. */
      std::size_t side = inside;
      /** Number of its centre. */
      std::size_t center = 0;
    };

    /** Convex. Parts that meet share a face. */
    struct Part
    {
      std::size_t body = 0;
      std::vector<std::size_t> faces;
      std::size_t center = 0;
    };

    using Tetrahedron = std::array<std::size_t, 4>;

    static constexpr std::size_t inside = static_cast<std::size_t>(-1);

    std::vector<Point> vertices;
    std::vector<Face> all_faces;
    std::vector<Part> parts;
    std::size_t n_sides = 6;

    FaceGroups
    faces() const override;
    /** By face. */
    std::vector<std::vector<std::size_t>>
    parts_at_faces() const;
    Point
    mean(const std::vector<std::size_t> &corners) const;
    Point
    center_of(const Part &part) const;
    Point
    normal_of(const Face &face) const;
    double
    distance(const Point &from, const Face &face) const;
    std::vector<double>
    lengths() const;
    /** Six times its volume, positive if the first vertex sees the others go round clockwise. */
    double
    volume(const Tetrahedron &cell) const;
    /** Calls @p action(part, cell) with every tetrahedron, all of one orientation. */
    void
    for_each_cell(const std::function<void(const Part &, const Tetrahedron &)> &action) const;
    std::vector<std::size_t>
    used_vertices() const;
    bool
    is_well_shaped(const double smallest) const;
    void
    divide_edges(const std::vector<bool> &is_cut, std::vector<double> &height);
    void
    divide_faces(const std::vector<bool> &is_cut, const std::vector<double> &height);
    std::size_t
    add_cut(const std::vector<std::size_t> &above);
    void
    split(const Point &normal, const double offset, const std::vector<bool> &which);
    void
    number_bodies();
  };
} // namespace fuga::stress

#endif
