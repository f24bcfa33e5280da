// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_joints_joint_readers_h
#define fuga_input_joints_joint_readers_h

#include <fuga/input/layer_law.h>
#include <fuga/input/values/parameter_values.h>

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** Data outside of the section of a joint on which reading its layer depends. */
  struct LayerSurroundings
  {
    const std::map<std::string, double> &constants;
    /** Stress up to which laws are checked [MPa]. */
    double largest_stress;
    /**
     * Laws that section Sweep assigns to the joint, whose section contains the entries of all of
     * them.
     */
    std::vector<LayerLaw> swept_normal_laws, swept_shear_laws;
    /** Whether the joint has shear strength, so that it needs a shear law. */
    bool has_shear;
  };

  /**
   * Read compliance and curve of one direction into @p joint, whose law is known, and check the
   * law.
   * @throws InputError for entries that are missing or belong to another law, and for laws that
   * check_law() refuses.
   */
  void
  read_layer(const ParameterSection &section,
             const LayerDirection direction,
             const LayerSurroundings &surroundings,
             JointParameters &joint);

  /** Read friction, bond and dilatancy of one joint. @throws InputError */
  FrictionLaw
  read_strength(const ParameterSection &section);

  /** Read the growth of the shear stiffness of a joint. @throws InputError */
  ShearGrowth
  read_shear_growth(const ParameterSection &section);

  /** Check that this growth is compatible with the joint's laws and friction. @throws InputError */
  void
  check_shear_growth(const ParameterSection &section, const JointParameters &joint);

  /** Read section Joints. @throws InputError */
  std::vector<JointParameters>
  read_joints(const ParameterValues &values, const ModelDefinition &model);
} // namespace fuga

#endif
