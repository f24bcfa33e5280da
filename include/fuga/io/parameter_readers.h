// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_readers_h
#define fuga_io_parameter_readers_h

#include <fuga/io/parameter_entries.h>
#include <fuga/io/parameter_expressions.h>
#include <fuga/io/parameter_values.h>
#include <fuga/io/parameters.h>
#include <fuga/io/sweep_plan.h>

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * The place of @p name among the @p known names of one section of the file. @p what: what they are,
   * in the singular.
   * @throws InputError at the @p entry of @p section where the name stands, if there is none.
   */
  unsigned int
  number_of(const std::string &name,
            const std::vector<std::string> &known,
            const std::string &what,
            const ParameterSection &section,
            const AnyEntry &entry);

  /** Fails at the entry if expression_problem() finds one in one of its expressions. */
  void
  check_expression(const ParameterSection &section,
                   const AnyEntry &entry,
                   const std::string &expression,
                   const ExpressionArguments arguments,
                   const std::map<std::string, double> &constants);

  /** Fails at @p one if both entries are given. */
  void
  refuse_both(const ParameterSection &section, const AnyEntry &one, const AnyEntry &other);

  /** What reading the layer of a joint depends on besides its own section. */
  struct LayerSurroundings
  {
    const std::map<std::string, double> &constants;
    /** Stress up to which laws are checked [MPa]. */
    double largest_stress;
    /** Laws that section Sweep gives the joint: the section of the joint has the entries of all of
     * them. */
    std::vector<LayerLaw> swept_normal_laws, swept_shear_laws;
    /** The joint has shear strength, so that it needs a shear law. */
    bool has_shear;
  };

  /**
   * Reads compliance and curve of one direction into @p joint, whose law is known, and checks the
   * law.
   * @throws InputError for entries that are missing or belong to another law, and for laws that
   * check_law() refuses.
   */
  void
  read_layer(const ParameterSection &section,
             const LayerDirection direction,
             const LayerSurroundings &surroundings,
             JointParameters &joint);

  /** Friction, bond and dilatancy of one joint. @throws InputError */
  FrictionLaw
  read_strength(const ParameterSection &section);

  /** How the shear stiffness of a joint grows. @throws InputError */
  ShearGrowth
  read_shear_growth(const ParameterSection &section);

  /** That it goes together with the joint's laws and friction. @throws InputError */
  void
  check_shear_growth(const ParameterSection &section, const JointParameters &joint);

  /** Section Joints. @throws InputError */
  std::vector<JointParameters>
  read_joints(const ParameterValues &values, const ModelDefinition &model);

  /** Section Boundaries of a plane problem. @throws InputError */
  std::vector<BoundaryCondition>
  read_boundaries(const ParameterValues &values, const unsigned int dimension);

  /** The numbers of "1, 2.5"; none if the text is not a list of numbers only. */
  std::vector<double>
  read_coordinates(const std::string &text);

  /** A level: a number, an expression of the load time or a table. @throws InputError */
  LevelDefinition
  read_level(const ParameterSection &section,
             const AnyEntry &entry,
             const std::map<std::string, double> &constants);

  /** The entries of a load that depends on the depth below a level. @throws InputError */
  DepthPressure
  read_depth_pressure(const ParameterSection &section,
                      const std::map<std::string, double> &constants);

  /** The table 'a: b; a: b' of an entry, with increasing a. @p form: how a point is written, for
   * messages. @throws InputError */
  std::vector<std::array<double, 2>>
  read_table(const ParameterSection &section, const AnyEntry &entry, const std::string &form);

  /** The entries of water in joints but for those of its level. @throws InputError */
  Uplift
  read_uplift(const ParameterSection &section, const ModelDefinition &model);

  /** The coefficients of a seismic load as the force per weight along every axis, expressions of a
   * weight. @throws InputError */
  std::vector<std::string>
  read_seismic_coefficients(const ParameterSection &section, const unsigned int dimension);

  /** Section Loads, each load for itself. @throws InputError */
  std::vector<LoadDefinition>
  read_loads(const ParameterValues &values, const ModelDefinition &model);

  /** Section Stages. @throws InputError */
  std::vector<StageDefinition>
  read_stages(const ParameterValues &values, const ModelDefinition &model);

  /** What an entry Point says: the name of a point, or the coordinates. */
  struct PointReference
  {
    std::string name;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
  };

  /** Entry Point of a section. @throws InputError */
  PointReference
  read_point(const ParameterSection &section, const Text &entry, const unsigned int dimension);

  /** Section Monitors. @throws InputError */
  std::vector<MonitorDefinition>
  read_monitors(const ParameterValues &values, const unsigned int dimension);

  /** When bodies are built and removed, and joints grouted. @throws InputError */
  void
  read_construction(const ParameterValues &values, ModelDefinition &model);

  /** @throws InputError if variants are to be run of something that is built in stages. */
  void
  check_sweep_of_construction(const ParameterValues &values, const Parameters &parameters);

  /** A file, or a variant of it. Errors go to @p errors and are thrown. */
  Parameters
  read_scan(const ParameterScan &scan, InputErrors &errors);

  /** All variants of a sweep. @throws InputError with the errors of all of them. */
  Parameters
  read_sweep(const SweepPlan &plan);

  /**
   * Section Safety: appends the stages that look for a factor of safety and marks the joints whose
   * strength is reduced. @throws InputError
   */
  void
  read_safety(const ParameterValues &values, Parameters &parameters);

  /** Section Target accuracy. @throws InputError */
  void
  read_accuracy(const ParameterValues &values, Parameters &parameters);

  /** What several sections together can get wrong. @throws InputError naming both culprits. */
  void
  check_loads_and_supports(const ParameterValues &values, const ModelDefinition &model);
} // namespace fuga

#endif
