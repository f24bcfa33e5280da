// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_joint_water_model_h
#define fuga_bodies_loads_joint_water_model_h

#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/contact/water_in_joints.h>

#include <array>
#include <memory>

namespace fuga
{
  /**
   * The water of all uplifts that follows the opening of the joints, as the contact layer sees it.
   * Water of one uplift reaches the elements of another where their joints meet.
   */
  template <int dim>
  class JointWaterModel : public WaterInJoints
  {
  public:
    /**
     * @p assemblies are by number of load, null for other loads; all arguments must outlive this
     * object.
     */
    JointWaterModel(const std::vector<std::unique_ptr<UpliftAssembly<dim>>> &assemblies,
                    const std::vector<LoadPattern> &patterns,
                    const ModelDefinition &model,
                    const Discretization<dim> &discretization,
                    const ContactBars<dim> &bars);

    /** Return whether the water of any pattern follows the opening. */
    static bool
    is_needed(const std::vector<LoadPattern> &patterns);

    const WaterNetwork &
    network() const override
    {
      return its_network;
    }

    Vector
    forces(const std::vector<WaterAccess> &access, const Vector &factors) const override;

  private:
    using Assemblies = std::vector<std::unique_ptr<UpliftAssembly<dim>>>;

    /** Forces of one access for all patterns, as far as they were needed. */
    struct Known
    {
      std::vector<WaterAccess> access;
      std::vector<Vector> columns;
    };

    void
    connect(const UpliftAssembly<dim> &assembly);

    const Known &
    known_forces(const std::vector<WaterAccess> &access, const Vector &factors) const;

    const Assemblies &assemblies;
    const std::vector<LoadPattern> &patterns;
    const Discretization<dim> &discretization;
    const ContactBars<dim> &bars;
    WaterNetwork its_network;
    /** The last two accesses that were needed: before and after an event. */
    mutable std::array<Known, 2> memory;
    mutable std::size_t last_used = 0;
  };
} // namespace fuga

#endif
