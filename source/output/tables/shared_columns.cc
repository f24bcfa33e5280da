// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/tables/history_columns.h>

namespace fuga
{
  namespace
  {
    template <double JointResultant::*member>
    TableField
    of_joint(const JointResultant &resultant)
    {
      return resultant.*member;
    }

    /** Return a component of a vector of a joint. */
    template <std::array<double, 3> JointResultant::*member, std::size_t component>
    TableField
    component_of(const JointResultant &resultant)
    {
      return (resultant.*member)[component];
    }

    template <double MotionLedger::*member>
    TableField
    of_motion(const MotionLedger &energies)
    {
      return energies.*member;
    }
  } // namespace

  Columns<JointResultant>
  resultant_quantities(const Units &u)
  {
    return {{"N", u.force, of_joint<&JointResultant::N>},
            {"T", u.force, of_joint<&JointResultant::T>},
            {"T2", u.force, of_joint<&JointResultant::T2>},
            {"M", u.energy(), of_joint<&JointResultant::M>},
            {"M1", u.energy(), of_joint<&JointResultant::M1>},
            {"Mn", u.energy(), of_joint<&JointResultant::Mn>},
            {"position_x", u.length, component_of<&JointResultant::position, 0>},
            {"position_y", u.length, component_of<&JointResultant::position, 1>},
            {"position_z", u.length, component_of<&JointResultant::position, 2>},
            {"share_open", "", of_joint<&JointResultant::share_open>},
            {"share_stick", "", of_joint<&JointResultant::share_stick>},
            {"share_slip", "", of_joint<&JointResultant::share_slip>},
            {"share_compression", "", of_joint<&JointResultant::share_compression>},
            {"largest_pressure", u.stress(), of_joint<&JointResultant::largest_pressure>},
            {"smallest_pressure", u.stress(), of_joint<&JointResultant::smallest_pressure>},
            {"largest_gap", u.length, of_joint<&JointResultant::largest_gap>},
            {"largest_slip", u.length, of_joint<&JointResultant::largest_slip>},
            {"mean_slip", u.length, of_joint<&JointResultant::mean_slip>},
            {"mean_slip2", u.length, of_joint<&JointResultant::mean_slip2>},
            {"sliding_safety", "", of_joint<&JointResultant::sliding_safety>},
            {"overturning_safety", "", of_joint<&JointResultant::overturning_safety>},
            {"eccentricity", u.length, of_joint<&JointResultant::eccentricity>},
            {"eccentricity2", u.length, of_joint<&JointResultant::eccentricity2>},
            {"in_middle_third", "", of_joint<&JointResultant::in_middle_third>},
            {"cracked_length", u.length, of_joint<&JointResultant::cracked_length>},
            {"crack_from_first", u.length, of_joint<&JointResultant::crack_from_first>},
            {"crack_from_last", u.length, of_joint<&JointResultant::crack_from_last>},
            {"water", u.force, of_joint<&JointResultant::water>},
            {"joint_dissipation", u.energy(), of_joint<&JointResultant::dissipation>},
            {"normal_x", "", component_of<&JointResultant::normal, 0>},
            {"normal_y", "", component_of<&JointResultant::normal, 1>},
            {"normal_z", "", component_of<&JointResultant::normal, 2>},
            {"t1_x", "", component_of<&JointResultant::first_tangent, 0>},
            {"t1_y", "", component_of<&JointResultant::first_tangent, 1>},
            {"t1_z", "", component_of<&JointResultant::first_tangent, 2>}};
  }

  Columns<MotionLedger>
  motion_energies(const Units &u)
  {
    return {{"work", u.energy(), of_motion<&MotionLedger::work>},
            {"kinetic_energy", u.energy(), of_motion<&MotionLedger::kinetic>},
            {"energy_bodies", u.energy(), of_motion<&MotionLedger::bodies>},
            {"damping", u.energy(), of_motion<&MotionLedger::damping>},
            {"joint_work", u.energy(), of_motion<&MotionLedger::joints>},
            {"numerical", u.energy(), of_motion<&MotionLedger::numerical>},
            {"sudden", u.energy(), of_motion<&MotionLedger::sudden>},
            {"largest_energy", u.energy(), of_motion<&MotionLedger::largest>}};
  }
} // namespace fuga
