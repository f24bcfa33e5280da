// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_model_definition_h
#define fuga_bodies_model_definition_h

#include <fuga/bodies/dynamics_definition.h>
#include <fuga/bodies/solver_choice.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** A cell of a refined mesh, by its way down from the coarse mesh: serial_cell_id(), binary. */
  using CellKey = std::array<unsigned int, 4>;

  /** Linear elastic material of one body. */
  struct Material
  {
    std::string body;
    /** E > 0 [MPa]. */
    double young_modulus = 0.;
    /** -1 < ν < 0.5. */
    double poisson_ratio = 0.;
    /** Weight per volume, ≥ 0 [MN/m³]; acts only through a load of kind weight. */
    double weight_density = 0.;
    /** α ≥ 0 [1/K]; acts only through a load of kind temperature. */
    double thermal_expansion = 0.;
    /** The body is there from the beginning of the first of these stages to that of the second. */
    unsigned int built_at   = 0;
    unsigned int removed_at = static_cast<unsigned int>(-1);
    /** With which the first dynamic stage begins [m/s]. */
    std::array<double, 3> initial_velocity = {{0., 0., 0.}};
  };

  /** What is assumed of the direction across the plane; without meaning in 3D. */
  enum class PlaneAssumption
  {
    /** No strain across the plane: dams, walls, strip foundations. Per unit (or given) thickness.
     */
    plane_strain,
    /** No stress across the plane: thin walls, plates in their plane. */
    plane_stress,
    /** The plane is half a section through a body of revolution: x = r ≥ 0, y the axis. Areas,
       volumes and forces are those of the full circle. */
    axisymmetric
  };

  /** What holds for a named part of the outer boundary (or a named point). */
  struct BoundaryCondition
  {
    /** Physical group of faces or of points. */
    std::string boundary;
    /** Components of the displacement that are held at zero (or moved by a displacement load). */
    std::array<bool, 3> fixed = {{false, false, false}};
    /** Stated by the user to carry neither support nor load. */
    bool named_free = false;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  enum class LoadKind
  {
    /** Own weight of the named bodies; expression = direction (0,-1 by default). Seismic
       coefficients are such a direction. */
    weight,
    /** Pressure on the named boundaries, positive towards the body [MPa]. */
    pressure,
    /** Pressure on the named boundaries below a level: DepthPressure. */
    depth_pressure,
    /** Pressure of the water in the named joints: Uplift. */
    uplift,
    /** Change of temperature of the named bodies [K]. */
    temperature,
    /** Traction vector on the named boundaries [MPa]. */
    traction,
    /** Force at a named point or at the vertex at given coordinates [MN]. */
    point_force,
    /** Settlement: displacement of fixed components of the named boundaries [m]. */
    displacement,
    /** What is taken off between the lips of the named joints [m]: a saw cut; filled in if
       negative: a jack, a wedge. */
    imposed_gap
  };

  /** The height of a surface of water as a function of the load time. */
  struct LevelDefinition
  {
    /** Points (load time, level), linear in between and constant outside; times increase. */
    std::vector<std::array<double, 2>> level_table;
    /** If the table is empty: muParser expression of the load time t. */
    std::string level;
  };

  /**
   * Pressure of water or earth, normal to the boundary and towards the body:
   *
   *   p = p₀ + γ d + r √(H d) at the depth d = level - y > 0, and 0 above the level,
   *
   * with H = level - bottom (> 0, else r counts for nothing). Still water has γ only; earth K γ and
   * p₀ = K q with the surcharge q; the water that an earthquake moves r = 7/8 k γ (H. M.
   * Westergaard, Water pressures on dams during earthquakes, Trans. ASCE 98, 1933).
   */
  struct DepthPressure : LevelDefinition
  {
    /** p₀ [MPa]. */
    double surcharge = 0.;
    /** γ [MN/m³]. */
    double gradient = 0.;
    /** r [MN/m³]. */
    double root = 0.;
    /** Where the depth H is counted from [m]. */
    double bottom = 0.;
  };

  /**
   * Water in joints between a reservoir, whose level is that of a DepthPressure with γ, and the
   * other end of the joints. Joints that meet are one way of the water. Where the joint is closed,
   * at the share s of the way,
   *
   *   u = u_d + φ(s) (u_u - u_d),
   *
   * with the pressures u_u, u_d of the depth below both levels at the ends of the way, or at the
   * tips of the cracks that are connected with reservoir and tailwater. In these cracks the
   * pressure is that of the depth below the level of the one with which they are connected.
   */
  struct Uplift
  {
    /** Where s is counted from. */
    enum class ProfileFrom
    {
      /** From the tip of the crack that is connected with the reservoir to the tip of the one that
       * is connected with the tailwater: codes of practice. */
      crack_tip,
      /** From one end of the joint to the other, however long the cracks are; no pressure of an
       * element of a crack from the reservoir is less than if it were closed. */
      joint
    };

    /** What a line of drains does that the crack has passed. */
    enum class Drains
    {
      lost,
      kept
    };

    ProfileFrom profile_from  = ProfileFrom::crack_tip;
    Drains drains_after_crack = Drains::lost;
    /** Horizontal or vertical direction from the upstream end to the other one. */
    std::array<double, 3> flow = {{1., 0., 0.}};
    bool has_tailwater         = false;
    LevelDefinition tailwater  = {};
    /** φ: points (s, φ), from s = 0 to 1, increasing; linear in between. */
    std::vector<std::array<double, 2>> profile = {{{0., 1.}}, {{1., 0.}}};
    /** A drain at this distance from the upstream end [m], if positive, lowers the linear φ there
     * to (1 - efficiency) of what it is (USACE, EM 1110-2-2200, 1995, section 3-3). */
    double drain_distance   = 0.;
    double drain_efficiency = 0.;
    /** Whether the pressure of the reservoir comes into open parts. */
    bool fills_cracks = true;
  };

  /** One load pattern: a field in space, multiplied in every stage by a history. */
  struct LoadDefinition
  {
    std::string name;
    LoadKind kind = LoadKind::weight;
    /** Bodies (weight, temperature), points (point_force), joints (uplift, imposed_gap) or, else,
     *  boundaries. */
    std::vector<std::string> targets;
    /** muParser expressions of x, y (, z), t: one for a pressure, temperature or gap, none for a
     *  depth pressure, else one per component; an empty expression of a displacement load leaves
     * that component alone. t is the load time. */
    std::vector<std::string> expressions;
    /** For a point force without target: the coordinates. */
    bool has_coordinates              = false;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    std::string origin;
    /** For a depth pressure; level and γ of an uplift. */
    DepthPressure depth = {};
    Uplift uplift       = {};

    bool
    has_level() const
    {
      return kind == LoadKind::depth_pressure || kind == LoadKind::uplift;
    }

    /** It prescribes deformations; no mass would answer to their change. */
    bool
    is_without_inertia() const
    {
      return kind == LoadKind::displacement || kind == LoadKind::imposed_gap ||
             kind == LoadKind::temperature;
    }
  };

  /** A point whose displacement is written. */
  struct MonitorDefinition
  {
    std::string name;
    /** Physical group of one point, or else the coordinates. */
    std::string point_name;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    /** On a joint: the body whose lip is meant; may be empty elsewhere. */
    std::string body;
    /** Whether the stress is wanted too. */
    bool stress = false;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  /** What a stage is for. */
  enum class StagePurpose
  {
    loading,
    /** Loads stand still while the strength of joints falls, see FrictionLaw::reduced. */
    strength_reduction,
    /** Some loads grow in proportion until nothing can carry them. */
    load_factor
  };

  /**
   * One load stage: t runs from its number (from 0) to the next one. Stages that look for a factor
   * of safety stand behind all others, each begins with the state at the end of the loads, and they
   * do not come one after another.
   */
  struct StageDefinition
  {
    struct History
    {
      /** Index into ModelDefinition::loads. */
      unsigned int load = 0;
      /** muParser expression of the stage fraction t ∈ [0, 1]. */
      std::string expression;
    };

    std::string name;
    std::vector<History> histories;
    /** Number of load levels written; level i is at the fraction i/levels. */
    unsigned int levels = 1;
    std::string origin;

    StagePurpose purpose = StagePurpose::loading;
    /** Of a stage in which inertia acts [s]; 0: loads are slow. */
    double duration = 0.;
    /** Of a search for safety: the factor at its end, > 1. */
    double largest_factor = 1.;
    /** Of a load factor: the loads that grow. */
    std::vector<unsigned int> increased_loads = {};
    /** The water in joints does not follow their opening. */
    bool keeps_water = false;
    /** Joints whose gaps are filled, without stress, at the beginning. */
    std::vector<std::string> grouted_joints = {};

    /** Whether inertia acts. */
    bool
    is_dynamic() const
    {
      return duration > 0.;
    }
  };

  /**
   * The bodies, their supports and loads, as the parameter file states them and before any mesh is
   * known. A load keeps the factor of its last history in the stages that do not name it, and is
   * zero before the first that does.
   */
  struct ModelDefinition
  {
    unsigned int dimension         = 2;
    unsigned int polynomial_degree = 1;
    /** Refinements of the whole mesh; then of the cells in these lists, one after the other, and of
     *  what has to follow (refine_marked_cells()); then once more of the whole mesh. */
    unsigned int refinements = 0;
    std::vector<std::vector<CellKey>> local_refinements;
    bool refined_once_more     = false;
    PlaneAssumption assumption = PlaneAssumption::plane_strain;
    /** Extent across the plane in 2D [m]; without meaning in axisymmetry. */
    double thickness = 1.;

    std::vector<Material> materials;
    std::vector<BoundaryCondition> boundary_conditions;
    std::vector<LoadDefinition> loads;
    std::vector<StageDefinition> stages;
    std::vector<MonitorDefinition> monitors;
    /** Into how many linear pieces a stage is cut if a history, or a load that depends on t, is not
     *  linear in t. */
    unsigned int load_knots = 20;
    /** How the bodies are eliminated. */
    BodySolver body_solver = BodySolver::automatic;
    /** Whether nothing that is asked for needs the stiffness of the interface as a matrix. */
    bool may_be_matrix_free = false;
    DynamicsDefinition dynamics;
    /** Named numbers for all expressions. */
    std::map<std::string, double> constants;
  };
} // namespace fuga

#endif
