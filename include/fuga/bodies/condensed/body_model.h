// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_body_model_h
#define fuga_bodies_condensed_body_model_h

#include <deal.II/lac/vector.h>

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/elasticity/equilibrium_error.h>
#include <fuga/bodies/joints/joint_face.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/contact/contact_element.h>

#include <array>

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
  class UpliftAssembly;


  /**
   * The finite element model of the bodies, their joints, supports and loads, before anything is
   * solved. Mesh and model must live as long as this object.
   */
  template <int dim>
  class BodyModel
  {
  public:
    /**
     * Discretises and checks. @p frictionless: joints that never carry shear; they get no tangential
     * bars, provided that the structure is held without them. @p stage: the bodies that are there in
     * it.
     * @throws InputError
     */
    BodyModel(const JointedMesh &mesh,
              const ModelDefinition &model,
              const std::vector<bool> &frictionless,
              const unsigned int stage);

    ~BodyModel();

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

    const JointGeometry<dim> &
    joint_geometry() const
    {
      return *geometry;
    }

    /** The pattern of load @p number of the model at load time @p t. */
    LoadPattern
    assemble_load(const std::size_t number, const double t) const;

    /** The assembly of load @p number, which is an uplift. */
    const UpliftAssembly<dim> &
    uplift(const std::size_t number) const;

    /** @throws InputError for a settlement that tears the two sides of a joint apart. */
    void
    check_load_patterns(const std::vector<LoadPattern> &patterns) const;

    std::vector<ElementIdentity>
    identities() const;

    /** Gᵀ p, entry node * dim + component. */
    Vector
    bar_forces(const Vector &p) const;

    /** Jump of every bar. */
    Vector
    jumps(const dealii::Vector<double> &u) const;

    /** Strain energy of every cell; u by nodes, entry node * dim + component. */
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

    /** Errors of the full model for displacement u, bar forces p and nodal forces @p loads (entry node
     * * dim + component; empty: none). @p motion: a rigid motion that was taken out of u, to whose
     * last digits the jumps are uncertain. */
    EquilibriumError
    equilibrium_error_under(const Vector &loads,
                            const dealii::Vector<double> &u,
                            const Vector &p,
                            const dealii::Vector<double> &motion) const;

    /** The same of bodies that move, where inertia is one of the @p loads. @p u, the displacement, is
     * right to its last digits, which may be more than all of what K feels of it, the @p
     * deformation (both by nodes). @p acting: see fuga::equilibrium_error(). */
    EquilibriumError
    equilibrium_error_in_motion(const Vector &loads,
                                const Vector &u,
                                const Vector &deformation,
                                const Vector &p,
                                const Vector &acting) const;

    /** Cᵀ (P - K u), of vectors by nodes. */
    Vector
    out_of_balance(const Vector &loads, const Vector &u) const;

    /** Of a vector by nodes. */
    dealii::Vector<double>
    by_degrees_of_freedom(const Vector &u) const;

    const ModelDefinition &
    definition() const
    {
      return model;
    }

    /** Whether supports are released: inertia acts, and nothing has to hold the bodies. */
    bool
    is_released() const
    {
      return floats;
    }

    const ContactBars<dim> &
    contact_bars() const
    {
      return *bars;
    }

    const InterfaceCoordinates<dim> &
    interface_coordinates() const
    {
      return *coordinates;
    }

    const ElasticBodies<dim> &
    elastic_bodies() const
    {
      return *bodies;
    }

    const RigidPieces<dim> &
    rigid_pieces() const
    {
      return *pieces;
    }

    /** By number of load the assemblies of uplifts that were asked for. */
    const std::vector<std::unique_ptr<UpliftAssembly<dim>>> &
    uplift_assemblies() const
    {
      return uplifts;
    }

    /** Lines for the log. */
    const std::vector<std::string> &
    report() const
    {
      return lines;
    }

    void
    add_to_report(const std::string &line)
    {
      lines.push_back(line);
    }

    /** Time and memory of every phase so far. */
    PhaseTimer &
    phases() const
    {
      return timer;
    }

  private:
    EquilibriumError
    equilibrium_error_of(
      Vector elastic, Vector terms, const Vector &p, Vector loads, const Vector &acting) const;

    void
    find_coordinates(const std::vector<bool> &frictionless);

    void
    list_joint_faces();

    void
    check_settlement(const Vector &prescribed) const;

    const JointedMesh &mesh;
    const ModelDefinition &model;
    const bool floats;
    std::unique_ptr<Discretization<dim>> space;
    std::vector<bool> fixed;
    std::unique_ptr<RigidPieces<dim>> pieces;
    std::unique_ptr<JointGeometry<dim>> geometry;
    std::unique_ptr<ContactBars<dim>> bars;
    std::unique_ptr<ElasticBodies<dim>> bodies;
    std::unique_ptr<InterfaceCoordinates<dim>> coordinates;
    /** By number of load; made when first asked for. */
    mutable std::vector<std::unique_ptr<UpliftAssembly<dim>>> uplifts;
    std::vector<JointFace> faces;
    std::vector<std::string> lines;
    mutable PhaseTimer timer;
  };
} // namespace fuga

#endif
