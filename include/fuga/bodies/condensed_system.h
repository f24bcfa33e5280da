// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_system_h
#define fuga_bodies_condensed_system_h

#include <deal.II/lac/vector.h>

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/bodies_work.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/equilibrium_error.h>
#include <fuga/bodies/joint_face.h>
#include <fuga/bodies/linear_response.h>
#include <fuga/bodies/load_assembly.h>
#include <fuga/bodies/rigid_projection.h>
#include <fuga/contact/contact_element.h>
#include <fuga/contact/contact_system.h>
#include <fuga/contact/tangent_solver.h>

#include <optional>

namespace dealii
{
  template <typename Number>
  class Vector;
}

namespace fuga
{
  template <int dim>
  class ContactBars;
  template <int dim>
  class ElasticBodies;
  template <int dim>
  class InterfaceCoordinates;
  template <int dim>
  class JointGeometry;
  template <int dim>
  class RigidPieces;
  template <int dim>
  class JointWaterModel;
  template <int dim>
  class UpliftAssembly;
  struct SymmetricTriplets;
  class InteriorSolver;
  class IterativeSolver;

  /** When the bodies are factorised: the expensive part. */
  enum class Condensation
  {
    at_once,
    /** By set_load_patterns(): a mistake in loads or joints is found before anything is computed.
     */
    with_loads,
    /** Not at all: the input is checked and nothing is computed. */
    never
  };

  /**
   * The finite element model as the contact layer sees it: everything but the jumps of the joints
   * eliminated by one partial factorisation. Mesh and model must live as long as this object. The
   * processes of a run share the work (doc/parallel.md); every one has the whole result.
   */
  template <int dim>
  class CondensedSystem : public ContactSystem, public TangentSolver
  {
  public:
    /**
     * Discretises, checks, assembles and factorises. @p frictionless: joints that never carry shear;
     * they get no tangential bars, provided that the structure is held without them. @p stage: the
     * bodies that are there in it.
     * @throws InputError, NumericalFailure
     */
    CondensedSystem(const JointedMesh &mesh,
                    const ModelDefinition &model,
                    const std::vector<bool> &frictionless,
                    const Condensation condensation = Condensation::at_once,
                    const unsigned int stage        = 0);

    ~CondensedSystem() override;

    const DenseMatrix &
    stiffness() const override
    {
      return S;
    }

    bool
    has_stiffness() const override
    {
      return used_solver != BodySolver::matrix_free;
    }

    Vector
    resistance(const Vector &x) const override;

    Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const double tolerance) const override;

    unsigned int
    n_coordinates() const;

    const DenseMatrix &
    load_patterns() const override
    {
      return F;
    }

    const DenseMatrix &
    jump_operator() const override;

    const DenseMatrix &
    imposed_jumps() const override
    {
      return E;
    }

    const DenseMatrix &
    rigid_motions() const override
    {
      return motions;
    }

    const DenseMatrix &
    rigid_coordinates() const override
    {
      return motion_coordinates;
    }

    const DenseMatrix &
    rigid_motion_loads() const override
    {
      return motion_loads;
    }

    const WaterInJoints *
    water_in_joints() const override;

    /** One line per uplift and way of its water. */
    std::vector<std::string>
    ways_of_water() const;

    /** Water in the closed joint: n_bars x n_patterns [MN]; empty without water. */
    const DenseMatrix &
    closed_water() const
    {
      return water_of_closed;
    }

    /** Contact elements with their geometry; gaps and laws are for others to fill in. */
    const std::vector<ContactElement> &
    elements() const;

    /** Local frame of an element: the unit normal, from the minus to the plus side. */
    std::array<double, 3>
    normal(const std::size_t element) const;

    /** The rest of it, see fuga::tangents(); in the plane the second one is zero. */
    std::array<std::array<double, 3>, 2>
    tangents(const std::size_t element) const;

    const std::vector<JointFace> &
    joint_faces() const
    {
      return faces;
    }

    /** UpliftAssembly::levels_of_kinks() of load @p number. */
    std::vector<double>
    levels_of_kinks(const std::size_t number) const;

    const JointGeometry<dim> &
    joint_geometry() const
    {
      return *geometry;
    }

    /** The pattern of load @p number of the model at load time @p t. */
    LoadPattern
    assemble_load(const std::size_t number, const double t) const;

    /** The pattern of load @p number, an uplift, were its levels these. */
    LoadPattern
    assemble_uplift(const std::size_t number, const WaterLevels &levels) const;

    /** What set_load_patterns() checks before it begins. @throws InputError for a settlement that
     * tears the two sides of a joint apart. */
    void
    check_load_patterns(const std::vector<LoadPattern> &patterns) const;

    /** Condenses the patterns; they stay here for recover() and equilibrium_error(). */
    void
    set_load_patterns(std::vector<LoadPattern> patterns);

    /** Says that pattern @p number is what an earlier phase of construction left, and that the bars
     *  feel @p jumps of it. To be called behind set_load_patterns(). */
    void
    set_carried_load(const std::size_t number, const Vector &jumps);

    const Vector &
    carried_load() const override
    {
      return carried;
    }

    /** Displacements in which bodies built later are free of stress. */
    void
    set_stress_free_shapes(std::vector<StressFreeShape> new_shapes)
    {
      shapes = std::move(new_shapes);
    }

    const std::vector<StressFreeShape> &
    stress_free_shapes() const
    {
      return shapes;
    }

    /** Work of nodal forces (entry node * dim + component) on the shape of bodies built in @p stage. */
    double
    stress_free_value(const Vector &force, const unsigned int stage) const;

    std::vector<ElementIdentity>
    identities() const;

    /** Gᵀ p, entry node * dim + component. */
    Vector
    bar_forces(const Vector &p) const;

    /** The displacement of all degrees of freedom for load factors @p a and interface coordinates @p
     * x. */
    dealii::Vector<double>
    recover(const Vector &a, const Vector &x) const;

    /** The displacement under nodal forces (entry node * dim + component; empty: none) and
     * interface coordinates (empty: zero), without supports that move. */
    dealii::Vector<double>
    bonded_field(const Vector &forces, const Vector &x) const;

    /**
     * The work of the nodal forces @p force (entry node * dim + component) on the displacement, for
     * any x and a: what recover() would give, without recovering (doc/theory.md, section 1).
     */
    LinearResponse
    response(const Vector &force) const;

    /** Interface coordinates as a rigid motion of the bodies that can move freely and the rest. */
    struct RigidPart
    {
      /** Displacement of all degrees of freedom in the rigid motion nearest to the coordinates. */
      dealii::Vector<double> motion;
      /** Coordinates without that motion. */
      Vector remainder;
    };

    /**
     * Splits interface coordinates: a body that soft joints hold moves by far more than it deforms,
     * and recover() of the remainder alone keeps the digits of the deformation.
     */
    RigidPart
    rigid_part(const Vector &x) const;

    /** Errors of the full model for displacement u, bar forces p and load factors a. @p motion: a
     * rigid motion that was taken out of u, to whose last digits the jumps are uncertain. */
    EquilibriumError
    equilibrium_error(const dealii::Vector<double> &u,
                      const Vector &p,
                      const Vector &a,
                      const dealii::Vector<double> &motion = {}) const;

    /** Nodal forces K u, numbered as u: reactions at the supports, minus the bar forces at the
     * lips.
     */
    dealii::Vector<double>
    nodal_forces(const dealii::Vector<double> &u) const;

    /** Jump of every bar. */
    Vector
    jumps(const dealii::Vector<double> &u) const;

    /** Strain energy of the bodies. */
    double
    bulk_energy(const dealii::Vector<double> &u) const;

    /** That of every cell; u by nodes, entry node * dim + component. */
    Vector
    cell_energies(const Vector &u) const;

    const Discretization<dim> &
    discretization() const
    {
      return *space;
    }

    const JointedMesh &
    jointed_mesh() const
    {
      return mesh;
    }

    /** Whether the component of a node (entry node * dim + component) is held. */
    const std::vector<bool> &
    fixed_dofs() const
    {
      return fixed;
    }

    BodiesWork
    work() const;

    /** Lines for the log. */
    const std::vector<std::string> &
    report() const
    {
      return lines;
    }

    /** Time and memory of every phase so far. */
    const PhaseTimer &
    phases() const
    {
      return timer;
    }

  private:
    void
    find_coordinates(const std::vector<bool> &frictionless);

    void
    condense();

    /** Returns lip_stiffness(). */
    Vector
    factorise();

    void
    report_sizes(const SymmetricTriplets &matrix);

    void
    choose_solver(SymmetricTriplets &matrix);

    Vector
    lip_stiffness(const SymmetricTriplets &matrix) const;

    void
    remove_rounding(const Vector &lips);

    void
    find_rigid_motions();

    void
    list_joint_faces();

    void
    check_settlement(const Vector &prescribed) const;

    DenseMatrix
    loads_out_of_balance() const;

    /** Cᵀ (P - K u). */
    Vector
    out_of_balance(const Vector &loads, const Vector &u) const;

    /** Adds to u the response to what is out of balance, with the jumps as they are. */
    void
    add_bonded_response(const Vector &loads, Vector &u) const;

    Vector
    combination(const Vector &a, const Vector LoadPattern::*part) const;

    dealii::Vector<double>
    by_degrees_of_freedom(const Vector &u) const;

    const JointedMesh &mesh;
    const ModelDefinition &model;

    std::unique_ptr<Discretization<dim>> space;
    std::vector<bool> fixed;
    std::unique_ptr<RigidPieces<dim>> pieces;
    std::unique_ptr<JointGeometry<dim>> geometry;
    std::unique_ptr<ContactBars<dim>> bars;
    std::unique_ptr<InterfaceCoordinates<dim>> coordinates;
    std::unique_ptr<ElasticBodies<dim>> bodies;
    std::unique_ptr<InteriorSolver> solver;
    /** The same solver if S is not known. */
    IterativeSolver *matrix_free_solver = nullptr;
    std::unique_ptr<RigidProjection> projection;
    BodySolver used_solver = BodySolver::direct;
    /** If the program had to choose. */
    std::optional<SolverEstimate> estimate;

    /** The assembly of load @p number, which is an uplift. */
    const UpliftAssembly<dim> &
    uplift(const std::size_t number) const;

    DenseMatrix S, F, E, motions, motion_loads, water_of_closed;
    /** By number of load; made when first asked for. */
    mutable std::vector<std::unique_ptr<UpliftAssembly<dim>>> uplifts;
    std::unique_ptr<JointWaterModel<dim>> water;
    /** The interface coordinates of the rigid motions. */
    DenseMatrix motion_coordinates;
    std::vector<LoadPattern> patterns;
    Vector carried;
    std::vector<StressFreeShape> shapes;
    std::vector<JointFace> faces;
    std::vector<std::string> lines;

    mutable PhaseTimer timer;
    mutable std::size_t n_recovered_fields = 0;
  };
} // namespace fuga

#endif
