// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_uplift_way_h
#define fuga_bodies_loads_uplift_way_h

#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/bodies/loads/water_line.h>

#include <string>

namespace fuga
{
  /**
   * The ways of the water of one uplift through its joints. Joints that meet form one way, joints
   * that do not meet have one each. In the plane the distance from the upstream end is measured
   * along the joints; in space, in the direction of flow, between ends that must be horizontal.
   */
  template <int dim>
  class UpliftWay
  {
  public:
    struct Way : WayOfWater
    {
      /** Joints in their order in the mesh. */
      std::vector<unsigned int> joints;
    };

    /** A face of a joint on its way; values at the corners of the face. */
    struct Face
    {
      const typename JointGeometry<dim>::Face *face = nullptr;
      std::size_t way                               = 0;
      /** Distance from the upstream end, and in space across the flow [m]. */
      Vector along, across;
    };

    /** @throws InputError for joints that branch, that do not extend in the direction of flow, or,
     * in space, whose ends are not horizontal; for a drain outside a way. */
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
    measure_in_space(const std::size_t way);
    void
    require_level_end(const std::size_t way, const double along, const double height) const;
    void
    require_extent(const std::size_t way, const double extent, const double size) const;
    void
    check_drain(const std::size_t way) const;

    std::string
    joints_of(const std::size_t way) const;

    const LoadDefinition &load;
    const JointedMesh &mesh;
    dealii::Tensor<1, dim> flow;
    std::vector<Way> all_ways;
    std::vector<Face> all_faces;
    /** Corners of all faces. */
    std::vector<std::vector<dealii::Point<dim>>> corners;
  };
} // namespace fuga

#endif
