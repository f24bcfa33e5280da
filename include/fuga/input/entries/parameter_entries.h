// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_entries_parameter_entries_h
#define fuga_input_entries_parameter_entries_h

#include <fuga/input/layer_law.h>
#include <fuga/input/syntax/parameter_declarations.h>

namespace fuga
{
  /*
   * The sections of a parameter file. Their constructors (parameter_table*.cc) give every entry its
   * name, which occurs nowhere else: readers and messages use the one defined here. Entries without
   * a member here are read into the structure to which the constructor binds them.
   */

  struct TopLevel : SectionDeclaration
  {
    TopLevel();
    Text title, output_directory;
    Integer dimension;
  };

  struct MeshEntries : SectionDeclaration
  {
    MeshEntries();
    Text file;
    Entry<PlaneAssumption> assumption;
    Number thickness;
  };

  struct BodyEntries : SectionDeclaration
  {
    BodyEntries();
    Number young_modulus, poisson_ratio, weight_density, thermal_expansion;
    Text built_at, removed_at, initial_velocity;
  };

  /** Law and curve of a joint's layer in one direction. */
  struct LayerEntries
  {
    void
    declare(SectionDeclaration &section, const LayerDirection direction);

    Entry<LayerLaw> law;
    Number compliance, stiffness;
    /** Limit of the closure; null in shear. */
    Number closure_limit;
    Number reference_deformation, reference_stress, exponent;
    Text table;
    Entry<TableInterpolation> interpolation;
    Text stress_expression, tangent_expression;
  };

  struct JointEntries : SectionDeclaration
  {
    JointEntries();
    Text line, plus_body, minus_body, plus_lip, minus_lip;
    LayerEntries normal, shear;
    Number thickness;
    Entry<ShearGrowth::Kind> shear_growth;
    Number growth_closure, growth_pressure, growth_exponent;
    Number friction_coefficient, friction_angle, residual_coefficient, residual_angle;
    Number envelope_exponent, envelope_pressure;
    Number cohesion, tensile_strength, dilatancy_angle, dilation_limit;
    Entry<FrictionLaw::BondLoss> bond_loss;
    Text initial_gap;

    const LayerEntries &
    layer(const LayerDirection direction) const
    {
      return direction == LayerDirection::normal ? normal : shear;
    }

  private:
    void
    declare_place();
    void
    declare_shear_growth();
    void
    declare_strength();
  };

  struct BoundaryEntries : SectionDeclaration
  {
    BoundaryEntries();
    Text fixed;
  };

  enum class LoadType
  {
    weight,
    seismic,
    temperature,
    pressure,
    hydrostatic,
    earth_pressure,
    westergaard,
    uplift,
    traction,
    point_force,
    displacement,
    imposed_gap
  };

  /** The end of a joint that lies in the reservoir. */
  enum class JointEnd
  {
    left,
    right,
    front,
    back,
    bottom,
    top
  };

  struct LoadEntries : SectionDeclaration
  {
    LoadEntries();
    Entry<LoadType> type;
    Text bodies, boundaries, point, value;
    Text level;
    Number unit_weight, earth_coefficient, surcharge, horizontal_coefficient;
    Text horizontal_direction;
    Number vertical_coefficient, bottom_level;
    Text joints;
    Entry<JointEnd> upstream_end;
    Text flow_direction;
    Entry<Uplift::ProfileFrom> profile_from;
    /** Whether the pressure of the reservoir enters cracks. */
    Entry<bool> cracks;
    Text tailwater_level;
    Number drain_distance, drain_efficiency;
    Entry<Uplift::Drains> drains_after_crack;
    Text pressure_profile;

  private:
    void
    declare_depth_and_shaking();
    void
    declare_uplift();
  };

  struct StageEntries : SectionDeclaration
  {
    StageEntries();
    Text loads, grouted_joints;
    Number duration;
    /** Whether the water in joints stands still. */
    Entry<bool> water;
  };

  struct DynamicsEntries : SectionDeclaration
  {
    DynamicsEntries();
    Number time_step, gravity, damping_ratio, longest_continuation, highest_frequency;
    Entry<SecondOrder> second_order;
    Entry<MotionBodies> bodies;
    Text massless_bodies, absorbing, damping_frequencies;
  };

  /** The format of a file with accelerations. */
  enum class RecordFormat
  {
    columns,
    /** Format of the Pacific Earthquake Engineering Research Center. */
    at2
  };

  enum class RecordUnit
  {
    g,
    /** Unit of length / s². */
    length
  };

  /** The place where the motion of a record was measured, or is to occur. */
  enum class RecordMotion
  {
    /** At the free surface of the rock of the base, where waves are reflected: twice the wave. */
    outcrop,
    /** In the upward wave. */
    upward_wave
  };

  struct EarthquakeEntries : SectionDeclaration
  {
    EarthquakeEntries();
    Text stage;
    /** Records along x, y, z. */
    std::array<Text, 3> records;
    Entry<RecordFormat> format;
    Integer time_column, acceleration_column;
    Number record_step, scale;
    Entry<RecordUnit> unit;
    Entry<Baseline> baseline;
    Text compliant_base, free_field;
    /** Determines the share of the record that is in the upward wave. */
    Entry<RecordMotion> motion;
    Text added_mass;
    Number level, bottom, unit_weight;
  };

  struct ConstantEntries : SectionDeclaration
  {
    ConstantEntries();
  };

  struct SolverEntries : SectionDeclaration
  {
    SolverEntries();
    Entry<bool> follow;
    Entry<LimitLoadChoice> beyond_limit;
    Entry<BodySolver> bodies;
  };

  struct SafetyEntries : SectionDeclaration
  {
    SafetyEntries();
    Entry<bool> strength_reduction;
    Text joints, load_factor;
    Number largest_factor;
  };

  struct SweepEntries : SectionDeclaration
  {
    SweepEntries();
    /** Whether the values of all lines are varied together, not in all combinations. */
    Entry<bool> combination;
    Text stages, joints;
    /** Entries of all joints, or of those that `joints` lists, by their own names. */
    std::vector<Text> older;
    Text load_sequences;
  };

  struct AccuracyEntries : SectionDeclaration
  {
    AccuracyEntries();
    Entry<AccuracyTarget::Quantity> quantity;
    Text joints, where, monitors, components;
  };

  struct MonitorEntries : SectionDeclaration
  {
    MonitorEntries();
    Text point, body;
  };

  struct OutputEntries : SectionDeclaration
  {
    OutputEntries();
    Entry<bool> spectra;
    Number field_interval;
    Text spectrum_periods;
    Text force_unit, length_unit;
  };
} // namespace fuga

#endif
