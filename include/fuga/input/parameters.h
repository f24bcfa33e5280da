// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_parameters_h
#define fuga_input_parameters_h

#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/bodies/model_definition.h>
#include <fuga/input/units.h>
#include <fuga/laws/friction_law.h>
#include <fuga/laws/tabular_law.h>
#include <fuga/mesh/joint_splitter.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /**
   * The curve of stress versus deformation of a joint layer in one direction, see ComplianceLaw.
   */
  enum class LayerLaw
  {
    /** ρ = 0; a linear law with compliance 0 also becomes rigid. */
    rigid,
    linear,
    /**
     * Law (9) of the paper as a secant stiffness; like the next law, it needs the thickness of the
     * layer.
     */
    cubic_root,
    /** Law (9) as a tangent stiffness. */
    cubic_root_tangent,
    /** See HyperbolicLaw; only in the normal direction. */
    hyperbolic,
    /** See ExponentialLaw; only in the normal direction. */
    exponential,
    /** See PowerLaw. */
    power,
    /** See TabularLaw. */
    tabular,
    /** See ExpressionLaw. */
    expression
  };

  /**
   * The parameters of the curve of one direction besides its compliance; 0 or empty = not given.
   */
  struct LayerCurve
  {
    /**
     * V_m of the hyperbolic law, or the limit of an expression, for which it is not required [m].
     */
    double closure_limit = 0.;
    /** A point of the exponential law (c0, p0) and of the power law (w_r, σ_r) [m, MPa]. */
    double reference_deformation = 0.;
    double reference_stress      = 0.;
    /** Exponent m of the power law. */
    double exponent = 0.;
    std::vector<TabularLaw::Point> table;
    TableInterpolation interpolation = TableInterpolation::monotone_spline;
    /** Stress and its derivative as muParser expressions of w. */
    std::string stress_expression;
    std::string tangent_expression;
  };

  /** Parameters of the growth of the shear stiffness of a joint, see ShearCoupling. */
  struct ShearGrowth
  {
    enum class Kind
    {
      none,
      closure,
      pressure
    };

    Kind kind = Kind::none;
    /** Scale of the growth: w_c [m] or σ_r [MPa]. */
    double scale    = 0.;
    double exponent = 1.;
  };

  /** One joint: its place in the mesh, its layer, its friction. */
  struct JointParameters
  {
    JointDefinition definition;

    LayerLaw normal_law = LayerLaw::linear;
    LayerLaw shear_law  = LayerLaw::linear;
    /**
     * Normal compliance ρn at zero deformation [m/MPa] of a linear, cubic root or hyperbolic law; 0
     * for all others.
     */
    double normal_compliance = 0.;
    /**
     * Shear compliance ρt, likewise. The shear law of a joint without friction and without a shear
     * compliance is rigid.
     */
    double shear_compliance = 0.;
    /** Thickness ζ0 [m]; 0 = not given. It is positive for every cubic root law. */
    double thickness = 0.;
    LayerCurve normal_curve, shear_curve;

    ShearGrowth shear_growth;
    FrictionLaw friction;
    /** Initial gap [m], a muParser expression of x, y (, z). */
    std::string initial_gap = "0";
    /** file:line of the subsection, for messages. */
    std::string origin;

    /**
     * Return ζ0/ρn [MPa], by which a user recognises a wrong unit; 0 if thickness or compliance is
     * 0.
     */
    double
    normal_layer_modulus() const
    {
      return normal_compliance > 0. ? thickness / normal_compliance : 0.;
    }
  };

  /** The method by which the equations of a nonlinear layer are solved. */
  enum class IterationKind
  {
    newton,
    /**
     * The paper's iteration with the stiffness at zero deformation; it may diverge, see its limits.
     */
    constant_stiffness
  };

  /** The choice to be made if there are several continuations of the path. */
  enum class NonUniqueChoice
  {
    stop,
    first,
    largest_dissipation
  };

  /** The choice to be made if the load cannot grow. */
  enum class LimitLoadChoice
  {
    stop,
    /** The load follows the motion of the mechanism. */
    arc_length,
    /** The bodies move with their inertia until they rest. */
    dynamic
  };

  struct SolverSettings
  {
    /** If false, the ends of stages are computed by implicit steps where possible. */
    bool follow_events           = true;
    NonUniqueChoice non_unique   = NonUniqueChoice::stop;
    bool follow_jumps            = false;
    LimitLoadChoice beyond_limit = LimitLoadChoice::stop;
    /** Growth of the largest jump up to which the arc-length method continues [m]; 0: default. */
    double beyond_jump              = 0.;
    IterationKind iteration         = IterationKind::newton;
    double iteration_tolerance      = 1e-12;
    unsigned int maximum_iterations = 200;
    /** A certificate above this ends the run with exit code 4. */
    double certificate_bound = 1e-9;
  };

  /** The times at which fields (VTU files) are written. */
  enum class FieldOutput
  {
    levels,
    end,
    never
  };

  /** The times at which a checkpoint is written, see Checkpoint. */
  enum class CheckpointOutput
  {
    levels,
    /** At levels, and at events as long as this costs next to nothing. */
    events,
    every_event,
    never
  };

  /** The times at which the displacements of the monitors are written. */
  enum class MonitorOutput
  {
    levels,
    /** At levels and at every event. */
    events
  };

  /** The amount of output on the screen. */
  enum class LogDetail
  {
    events,
    levels,
    quiet
  };

  /**
   * Settings of the response spectra of the accelerations of the monitors in stages with a
   * duration.
   */
  struct SpectrumSettings
  {
    bool wanted    = false;
    double damping = 0.05;
    /** Periods of the spectrum [s]. */
    std::vector<double> periods;
  };

  struct OutputSettings
  {
    /**
     * Directory of the results, never empty; relative names are relative to the current directory
     * of the process.
     */
    std::string directory;
    FieldOutput fields = FieldOutput::levels;
    /** Time between the fields of bodies in motion [s]; 0: only at levels. */
    double field_interval       = 0.;
    MonitorOutput monitors      = MonitorOutput::levels;
    CheckpointOutput checkpoint = CheckpointOutput::levels;
    LogDetail log               = LogDetail::events;
    SpectrumSettings spectra;
    /** Whether report.html is made at the end. */
    bool report = false;
    Units units;
  };

  /** The contents of section Target accuracy. */
  struct AccuracyTarget
  {
    enum class Quantity
    {
      none,
      pressure,
      resultant,
      monitor
    };

    Quantity quantity = Quantity::none;
    /** Joints or monitors that count. */
    std::vector<unsigned int> items;
    /**
     * Components that count, as 0, 1, 2 ...: N, T, M, T2, M1, Mn of a resultant, x, y, z of a
     * monitor.
     */
    std::vector<unsigned int> components;
    /** Expression of the position: the pressure counts where it is not 0; empty: everywhere. */
    std::string where;
    double relative_error   = 0.01;
    double max_unknowns     = 1e6;
    unsigned int max_rounds = 20;
    /** file:line of the quantity, for messages. */
    std::string origin;
  };

  struct Parameters;

  /** A quantity that a line of section Sweep varies. */
  struct SweptQuantity
  {
    /** The name as written in the file, for the table. */
    std::string name;
    /** The unit; empty for words, ratios and texts. */
    std::string unit;
    /** The present form of the line, after `set`, if it was written in an older form. */
    std::string today;
  };

  /** One of the runs of a sweep. */
  struct Variant
  {
    /** Values of the varied quantities, in the order of Parameters::swept. */
    std::vector<std::string> settings;
    /** All joints, as they are in this variant. */
    std::vector<JointParameters> joints;
    /** Motion of the ground, see DynamicsDefinition::ground. */
    std::array<GroundMotion, 3> ground;
    /** Index into Parameters::condensations, for everything else. */
    std::size_t condensation = 0;
  };

  /** The complete contents of a parameter file. */
  struct Parameters
  {
    std::string title;
    /** The name of the file as given on the command line. */
    std::string parameter_file;
    /**
     * The mesh file, which exists; its name is already resolved against the folder of the parameter
     * file.
     */
    std::string mesh_file;

    /** The model, whose constants contain "pi" in addition to those of the user. */
    ModelDefinition model;
    std::vector<JointParameters> joints;
    /**
     * The contents of section Sweep, all empty without it. Variants with the same condensation
     * follow one another, and so do, among them, those that differ only in strength.
     */
    std::vector<SweptQuantity> swept;
    std::vector<Variant> variants;
    /**
     * Parameters common to variants that have the same mesh, bodies, supports, loads and settings.
     * The joints and the motion of the ground are those of the first of these variants.
     */
    std::vector<std::shared_ptr<const Parameters>> condensations;
    /**
     * Whether these are the parameters of variants; everything else is then that of the first
     * variant.
     */
    bool of_sweep = false;
    AccuracyTarget accuracy;
    SolverSettings solver;
    OutputSettings output;

    /** (path, value) of every entry that was given or has a default, in the order of
     *  default_parameter_text(); e.g. ("Bodies/dam/Young modulus", "3060"). */
    std::vector<std::pair<std::string, std::string>> echo;
  };

  /** Return whether inertia acts in a stage, or may act beyond a limit load. */
  inline bool
  may_move(const Parameters &parameters)
  {
    return has_dynamic_stage(parameters.model) ||
           parameters.solver.beyond_limit == LimitLoadChoice::dynamic;
  }
} // namespace fuga

#endif
