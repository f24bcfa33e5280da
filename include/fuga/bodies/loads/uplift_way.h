// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_uplift_way_h
#define fuga_bodies_loads_uplift_way_h

#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/bodies/loads/plan_outline.h>
#include <fuga/bodies/loads/water_line.h>
#include <fuga/bodies/space/face_map.h>

#include <string>

namespace fuga
{
  /**
   * The ways of the water of one uplift through its joints. Joints that meet form one way, joints
   * that do not meet have one each. In the plane the coordinate along the flow is the distance from
   * the upstream end, measured along the joints. In space it is the one in the direction of flow;
   * every line in that direction has its own ends where it enters and leaves the joints.
   */
  template <int dim>
  class UpliftWay
  {
  public:
    struct Way
    {
      /** Joints in their order in the mesh. */
      std::vector<unsigned int> joints;
      /** Its ends, and in space its sides. */
      PlanOutline outline;
      /** The least and the largest distance between the ends [m]. */
      double shortest = 0., longest = 0.;
    };

    /** A face of a joint on its way; values at the corners of the face. */
    struct Face
    {
      const typename JointGeometry<dim>::Face *face = nullptr;
      std::size_t way                               = 0;
      /** Coordinates along and across the flow [m]; in the plane the latter is zero. */
      Vector along, across;
    };

    /** @throws InputError for joints that branch, that do not extend in the direction of flow, or,
     * in space, that lines in this direction leave and enter again, or that stand upright beside
     * the flow; for a drain outside a way. */
    UpliftWay(const LoadDefinition &load,
              const Discretization<dim> &discretization,
              const JointGeometry<dim> &geometry,
              const JointedMesh &mesh);

    const std::vector<Way> &
    ways() const
    {
      return all_ways;
    }

    const std::vector<Face> &
    faces() const
    {
      return all_faces;
    }

    /** Return the way of the water on the line at the coordinate @p across. */
    WayOfWater
    line(const std::size_t way, const double across) const;

    /** Return the corners of a face. */
    std::vector<PlanPoint>
    corner_points(const std::size_t face) const;

    /** Return the points of a figure on a face, @p map, with these corners. */
    std::vector<PlanPoint>
    points(const Face &face,
           const FaceMap<dim> &map,
           const std::vector<typename FaceMap<dim>::FacePoint> &figure) const;

    /**
     * Return the ways of the water that reach the @p points of a figure. Where the joint has a step
     * at its end, at a point on the border of two lines, it is that of the line inside the figure.
     */
    std::vector<WayOfWater>
    lines_through(const std::size_t way, const std::vector<PlanPoint> &points) const;

    /** Return one line for the log per way: the rule, the joints. */
    std::vector<std::string>
    report() const;

  private:
    /** Assign the faces to ways, which are numbered by their first face. */
    void
    find_ways(const std::vector<std::vector<std::size_t>> &places);
    void
    measure_chain(const std::size_t way,
                  const std::vector<std::vector<std::size_t>> &places,
                  const std::vector<dealii::Point<dim>> &positions);
    void
    measure_in_space(const std::size_t way, const std::vector<std::vector<std::size_t>> &places);

    /** Return the unit vector across the flow in the mean plane of @p faces. */
    dealii::Tensor<1, dim>
    direction_across(const std::vector<std::size_t> &faces) const;
    /** Return the outline of @p faces: the edges that belong to one of them. */
    PlanOutline
    outline_of(const std::vector<std::size_t> &faces,
               const std::vector<std::vector<std::size_t>> &places) const;
    /** Measure the lines, which may not leave the joints between their ends. */
    void
    measure_lines(const std::size_t way, const std::vector<std::size_t> &faces);
    void
    require_extent(const std::size_t way, const double extent, const double size) const;
    void
    check_drain(const std::size_t way) const;

    std::string
    joints_of(const std::size_t way) const;
    /** Return the direction of flow for messages. */
    std::string
    flow_text() const;

    /** Share of the size of a way that counts as no distance. */
    static constexpr double same_place = 1e-6;

    const LoadDefinition &load;
    const JointedMesh &mesh;
    dealii::Tensor<1, dim> flow;
    std::vector<Way> all_ways;
    std::vector<Face> all_faces;
    /** Corners of all faces, and the normals that point out of their bodies. */
    std::vector<std::vector<dealii::Point<dim>>> corners;
    std::vector<dealii::Tensor<1, dim>> outward;
  };
} // namespace fuga

#endif
