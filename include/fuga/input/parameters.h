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
  /** The curve of stress against deformation of a joint layer in one direction; see ComplianceLaw.
   */
  enum class LayerLaw
  {
    /** ρ = 0; also what a linear law with compliance 0 becomes. */
    rigid,
    linear,
    /** Law (9) of the paper as a secant; needs the thickness of the layer, as the next one does. */
    cubic_root,
    /** Law (9) as a tangent. */
    cubic_root_tangent,
    /** HyperbolicLaw, in the normal direction only. */
    hyperbolic,
    /** ExponentialLaw, in the normal direction only. */
    exponential,
    /** PowerLaw. */
    power,
    /** TabularLaw. */
    tabular,
    /** ExpressionLaw. */
    expression
  };

  /** What the curve of one direction has besides its compliance; 0 or empty = not given. */
  struct LayerCurve
  {
    /** V_m of the hyperbolic law; the limit of an expression, which may do without [m]. */
    double closure_limit = 0.;
    /** A point of the exponential law (c0, p0) and of the power law (w_r, σ_r) [m, MPa]. */
    double reference_deformation = 0.;
    double reference_stress      = 0.;
    /** m of the power law. */
    double exponent = 0.;
    std::vector<TabularLaw::Point> table;
    TableInterpolation interpolation = TableInterpolation::monotone_spline;
    /** muParser expressions of w. */
    std::string stress_expression;
    std::string tangent_expression;
  };

  /** How the shear stiffness of a joint grows, see ShearCoupling. */
  struct ShearGrowth
  {
    enum class Kind
    {
      none,
      closure,
      pressure
    };

    Kind kind = Kind::none;
    /** w_c [m] or σ_r [MPa]. */
    double scale    = 0.;
    double exponent = 1.;
  };

  /** One joint: where it is in the mesh, its layer, its friction. */
  struct JointParameters
  {
    JointDefinition definition;

    LayerLaw normal_law = LayerLaw::linear;
    LayerLaw shear_law  = LayerLaw::linear;
    /** ρn at zero deformation [m/MPa] of a linear, cubic root or hyperbolic law; 0 for all others.
     */
    double normal_compliance = 0.;
    /** ρt, likewise. A joint without friction and without a shear compliance is rigid here. */
    double shear_compliance = 0.;
    /** ζ0 [m]; 0 = not given. Positive for every cubic root law. */
    double thickness = 0.;
    LayerCurve normal_curve, shear_curve;

    ShearGrowth shear_growth;
    FrictionLaw friction;
    /** muParser expression of x, y for the initial gap [m]. */
    std::string initial_gap = "0";
    /** file:line of the subsection, for messages. */
    std::string origin;

    /** ζ0/ρn [MPa], what a user recognises a slip of units by; 0 if thickness or compliance is 0.
     */
    double
    normal_layer_modulus() const
    {
      return normal_compliance > 0. ? thickness / normal_compliance : 0.;
    }
  };

  /** How the equations of a nonlinear layer are solved. */
  enum class IterationKind
  {
    newton,
    /** The paper's iteration with the stiffness at zero deformation; may diverge, see its limits.
     */
    constant_stiffness
  };

  /** What happens where the joints can go on in several ways. */
  enum class NonUniqueChoice
  {
    stop,
    first,
    largest_dissipation
  };

  /** What happens where the load cannot grow. */
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
    /** False: stage ends by implicit steps where possible. */
    bool follow_events           = true;
    NonUniqueChoice non_unique   = NonUniqueChoice::stop;
    bool follow_jumps            = false;
    LimitLoadChoice beyond_limit = LimitLoadChoice::stop;
    /** By arc length until the largest jump has grown by this [m]; 0: by default. */
    double beyond_jump              = 0.;
    IterationKind iteration         = IterationKind::newton;
    double iteration_tolerance      = 1e-12;
    unsigned int maximum_iterations = 200;
    /** A certificate above this ends the run with exit code 4. */
    double certificate_bound = 1e-9;
  };

  /** When fields (VTU files) are written. */
  enum class FieldOutput
  {
    levels,
    end,
    never
  };

  /** When a checkpoint is written, see Checkpoint. */
  enum class CheckpointOutput
  {
    levels,
    /** Levels, and events as long as that costs next to nothing. */
    events,
    every_event,
    never
  };

  /** When the displacements of the monitors are written. */
  enum class MonitorOutput
  {
    levels,
    /** At levels and at every event. */
    events
  };

  /** What gets a line on the screen. */
  enum class LogDetail
  {
    events,
    levels,
    quiet
  };

  /** Of the accelerations of the monitors in stages with a duration. */
  struct SpectrumSettings
  {
    bool wanted    = false;
    double damping = 0.05;
    /** [s] */
    std::vector<double> periods;
  };

  struct OutputSettings
  {
    /** Never empty; relative names are relative to the current directory of the process. */
    std::string directory;
    FieldOutput fields = FieldOutput::levels;
    /** Time between those of bodies in motion [s]; 0: only at levels. */
    double field_interval       = 0.;
    MonitorOutput monitors      = MonitorOutput::levels;
    CheckpointOutput checkpoint = CheckpointOutput::levels;
    LogDetail log               = LogDetail::events;
    SpectrumSettings spectra;
    /** Whether report.html is made at the end. */
    bool report = false;
    Units units;
  };

  /** What section Target accuracy says. */
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
    /** Of a resultant N, T, M, T2, M1, Mn, of a monitor x, y, z, as 0, 1, 2 ... */
    std::vector<unsigned int> components;
    /** Expression of the place: the pressure counts where it is not 0; empty: everywhere. */
    std::string where;
    double relative_error   = 0.01;
    double max_unknowns     = 1e6;
    unsigned int max_rounds = 20;
    /** file:line of the quantity, for messages. */
    std::string origin;
  };

  struct Parameters;

  /** What a line of section Sweep varies. */
  struct SweptQuantity
  {
    /** As written in the file, for the table. */
    std::string name;
    /** Empty for words, ratios and texts. */
    std::string unit;
    /** How the line is written today, after `set`, if it has an older form. */
    std::string today;
  };

  /** One of the runs of a sweep. */
  struct Variant
  {
    /** Values of what is varied, in the order of Parameters::swept. */
    std::vector<std::string> settings;
    /** All joints, as they are in this variant. */
    std::vector<JointParameters> joints;
    /** DynamicsDefinition::ground. */
    std::array<GroundMotion, 3> ground;
    /** Index into Parameters::condensations, for all else. */
    std::size_t condensation = 0;
  };

  /** Everything a parameter file says. */
  struct Parameters
  {
    std::string title;
    /** As given on the command line. */
    std::string parameter_file;
    /** Exists; its name is already resolved against the folder of the parameter file. */
    std::string mesh_file;

    /** The constants contain "pi" besides those of the user. */
    ModelDefinition model;
    std::vector<JointParameters> joints;
    /** Of section Sweep, all empty without it. Variants with the same condensation follow one
     * another, and among them those that differ in strength only. */
    std::vector<SweptQuantity> swept;
    std::vector<Variant> variants;
    /** What variants share that have the same mesh, bodies, supports, loads and settings. Their
     * joints and the motion of the ground are those of the first of them. */
    std::vector<std::shared_ptr<const Parameters>> condensations;
    /** These are the parameters of variants. All else is then that of the first variant. */
    bool of_sweep = false;
    AccuracyTarget accuracy;
    SolverSettings solver;
    OutputSettings output;

    /** (path, value) of every entry that was given or has a default, in the order of
     *  default_parameter_text(); e.g. ("Bodies/dam/Young modulus", "3060"). */
    std::vector<std::pair<std::string, std::string>> echo;
  };

  /** Whether inertia acts in a stage, or may act beyond a limit load. */
  inline bool
  may_move(const Parameters &parameters)
  {
    return has_dynamic_stage(parameters.model) ||
           parameters.solver.beyond_limit == LimitLoadChoice::dynamic;
  }
} // namespace fuga

#endif
