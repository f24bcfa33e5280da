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
  /**
   * A cell of a refined mesh, identified by its path from the coarse mesh: serial_cell_id(),
   * binary.
   */
  using CellKey = std::array<unsigned int, 4>;

  /** Linear elastic material of one body. */
  struct Material
  {
    std::string body;
    /** Young's modulus E > 0 [MPa]. */
    double young_modulus = 0.;
    /** Poisson's ratio, -1 < ν < 0.5. */
    double poisson_ratio = 0.;
    /** Weight per volume, ≥ 0 [MN/m³]; acts only through a load of kind weight. */
    double weight_density = 0.;
    /**
     * Coefficient of thermal expansion α ≥ 0 [1/K]; acts only through a load of kind temperature.
     */
    double thermal_expansion = 0.;
    /** The body exists from the beginning of the first of these stages to that of the second. */
    unsigned int built_at   = 0;
    unsigned int removed_at = static_cast<unsigned int>(-1);
    /** Velocity at the beginning of the first dynamic stage [m/s]. */
    std::array<double, 3> initial_velocity = {{0., 0., 0.}};
  };

  /** The assumption about the direction across the plane; without meaning in 3D. */
  enum class PlaneAssumption
  {
    /** No strain across the plane: dams, walls, strip foundations. Per unit (or given) thickness.
     */
    plane_strain,
    /** No stress across the plane: thin walls, plates in their plane. */
    plane_stress,
    /**
     * The plane is half a section through a body of revolution: x = r ≥ 0, y is the axis. Areas,
     * volumes and forces are those of the full circle.
     */
    axisymmetric
  };

  /** The condition on a named part of the outer boundary (or on a named point). */
  struct BoundaryCondition
  {
    /** Physical group of faces or of points. */
    std::string boundary;
    /** Components of the displacement that are held at zero (or moved by a displacement load). */
    std::array<bool, 3> fixed = {{false, false, false}};
    /** Whether the user declared that it has neither support nor load. */
    bool named_free = false;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  enum class LoadKind
  {
    /**
     * Own weight of the named bodies; the expression is the direction (0,-1 by default). Seismic
     * coefficients are such a direction.
     */
    weight,
    /** Pressure on the named boundaries, positive towards the body [MPa]. */
    pressure,
    /** Pressure on the named boundaries below a level, see DepthPressure. */
    depth_pressure,
    /** Pressure of the water in the named joints, see Uplift. */
    uplift,
    /** Change of temperature of the named bodies [K]. */
    temperature,
    /** Traction vector on the named boundaries [MPa]. */
    traction,
    /** Force at a named point or at the vertex at given coordinates [MN]. */
    point_force,
    /** Settlement: displacement of fixed components of the named boundaries [m]. */
    displacement,
    /**
     * Thickness that is removed between the lips of the named joints [m]: a saw cut; if negative,
     * it is filled in: a jack, a wedge.
     */
    imposed_gap
  };

  /** The height of a surface of water as a function of the load time. */
  struct LevelDefinition
  {
    /** Points (load time, level), linear in between and constant outside; times increase. */
    std::vector<std::array<double, 2>> level_table;
    /** The level as a muParser expression of the load time t, if the table is empty. */
    std::string level;
  };

  /**
   * Pressure of water or earth, normal to the boundary and towards the body:
   *
   *   p = p₀ + γ d + r √(H d) at the depth d = level - y > 0, and 0 above the level,
   *
   * with H = level - bottom (> 0, otherwise r has no effect). Still water has γ only; earth has K γ
   * and p₀ = K q with the surcharge q; water moved by an earthquake has r = 7/8 k γ (H. M.
   * Westergaard, Water pressures on dams during earthquakes, Trans. ASCE 98, 1933).
   */
  struct DepthPressure : LevelDefinition
  {
    /** Pressure p₀ at the level [MPa]. */
    double surcharge = 0.;
    /** Gradient γ of the pressure [MN/m³]. */
    double gradient = 0.;
    /** Coefficient r of the square root [MN/m³]. */
    double root = 0.;
    /** The level from which the depth H is measured [m]. */
    double bottom = 0.;
  };

  /**
   * Water in joints between a reservoir, whose level is that of a DepthPressure with γ, and the
   * other end of the joints. Joints that meet form one path of the water. Where the joint is
   * closed, at the fraction s of the path,
   *
   *   u = u_d + φ(s) (u_u - u_d),
   *
   * with the pressures u_u, u_d due to the depths below both levels at the ends of the path, or at
   * the tips of the cracks that are connected with reservoir and tailwater. In these cracks the
   * pressure is that of the depth below the level of the water with which they are connected.
   */
  struct Uplift
  {
    /** The point from which s is measured. */
    enum class ProfileFrom
    {
      /**
       * From the tip of the crack that is connected with the reservoir to the tip of the one that
       * is connected with the tailwater, as in codes of practice.
       */
      crack_tip,
      /**
       * From one end of the joint to the other, however long the cracks are; the pressure of an
       * element in a crack connected with the reservoir is never less than if the element were
       * closed.
       */
      joint
    };

    /** The effect of a line of drains that the crack has passed. */
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
    /** Profile φ: points (s, φ), from s = 0 to 1, in increasing order; linear in between. */
    std::vector<std::array<double, 2>> profile = {{{0., 1.}}, {{1., 0.}}};
    /**
     * A drain at this distance from the upstream end [m], if positive, reduces the linear φ there
     * by the factor 1 - efficiency (USACE, EM 1110-2-2200, 1995, section 3-3).
     */
    double drain_distance   = 0.;
    double drain_efficiency = 0.;
    /** Whether the pressure of the reservoir enters open parts. */
    bool fills_cracks = true;
  };

  /** One load pattern: a field in space, multiplied in every stage by a history. */
  struct LoadDefinition
  {
    std::string name;
    LoadKind kind = LoadKind::weight;
    /**
     * Bodies (weight, temperature), points (point_force), joints (uplift, imposed_gap) or,
     * otherwise, boundaries.
     */
    std::vector<std::string> targets;
    /**
     * muParser expressions of x, y (, z), t: one for a pressure, temperature or gap, none for a
     * depth pressure, otherwise one per component; an empty expression of a displacement load does
     * not affect that component. t is the load time.
     */
    std::vector<std::string> expressions;
    /** The coordinates of a point force without target. */
    bool has_coordinates              = false;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    std::string origin;
    /** The data of a depth pressure, or level and γ of an uplift. */
    DepthPressure depth = {};
    Uplift uplift       = {};

    bool
    has_level() const
    {
      return kind == LoadKind::depth_pressure || kind == LoadKind::uplift;
    }

    /** Return whether the load prescribes deformations, to whose change no mass would respond. */
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
    /** Physical group of one point, otherwise the coordinates. */
    std::string point_name;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    /** On a joint, the body whose lip is meant; it may be empty elsewhere. */
    std::string body;
    /** Whether the stress is also written. */
    bool stress = false;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  /** The purpose of a stage. */
  enum class StagePurpose
  {
    loading,
    /** Loads remain constant while the strength of joints is reduced, see FrictionLaw::reduced. */
    strength_reduction,
    /** Some loads grow proportionally until they cannot be carried any more. */
    load_factor
  };

  /**
   * One load stage: t runs from its number (from 0) to the next one. Stages that search for a
   * factor of safety come after all others; each begins with the state at the end of the loads, and
   * they do not follow one another.
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
    /** Duration of a stage in which inertia acts [s]; 0: loads are slow. */
    double duration = 0.;
    /** Factor at the end of a search for a factor of safety, > 1. */
    double largest_factor = 1.;
    /** The loads that grow in a search for a load factor. */
    std::vector<unsigned int> increased_loads = {};
    /** Whether the water in joints does not follow their opening. */
    bool keeps_water = false;
    /** Joints whose gaps are filled, without stress, at the beginning. */
    std::vector<std::string> grouted_joints = {};

    /** Return whether inertia acts. */
    bool
    is_dynamic() const
    {
      return duration > 0.;
    }
  };

  /**
   * The bodies, their supports and loads, as given in the parameter file and before any mesh is
   * known. A load keeps the factor of its last history in the stages that do not name it, and is
   * zero before the first one that does.
   */
  struct ModelDefinition
  {
    unsigned int dimension         = 2;
    unsigned int polynomial_degree = 1;
    /**
     * Refinements of the whole mesh; followed by refinements of the cells in these lists, one after
     * the other, with those that they entail (refine_marked_cells()); followed by one more
     * refinement of the whole mesh.
     */
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
    /**
     * Number of linear pieces into which a stage is divided if a history, or a load that depends on
     * t, is not linear in t.
     */
    unsigned int load_knots = 20;
    /** The method by which the bodies are eliminated. */
    BodySolver body_solver = BodySolver::automatic;
    /** Whether no requested result needs the stiffness of the interface as a matrix. */
    bool may_be_matrix_free = false;
    DynamicsDefinition dynamics;
    /** Named numbers for all expressions. */
    std::map<std::string, double> constants;
  };
} // namespace fuga

#endif
