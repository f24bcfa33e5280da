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
     * Discretise and check the bodies. @p frictionless joints never carry shear and get no
     * tangential bars, provided that the structure is held without them. @p stage determines which
     * bodies exist.
     * @throws InputError
     */
    BodyModel(const JointedMesh &mesh,
              const ModelDefinition &model,
              const std::vector<bool> &frictionless,
              const unsigned int stage);

    ~BodyModel();

    /**
     * Return the contact elements with their geometry; gaps and laws have to be added by the
     * caller.
     */
    const std::vector<ContactElement> &
    elements() const;

    /** Return the unit normal of an element, from the minus to the plus side. */
    std::array<double, 3>
    normal(const std::size_t element) const;

    /**
     * Return the tangents of an element, see fuga::tangents(); in the plane the second one is zero.
     */
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

    /** Return the pattern of load @p number of the model at load time @p t. */
    LoadPattern
    assemble_load(const std::size_t number, const double t) const;

    /** Return the assembly of load @p number, which is an uplift. */
    const UpliftAssembly<dim> &
    uplift(const std::size_t number) const;

    /**
     * Check load patterns. @throws InputError for a settlement that tears the two sides of a joint
     * apart.
     */
    void
    check_load_patterns(const std::vector<LoadPattern> &patterns) const;

    std::vector<ElementIdentity>
    identities() const;

    /** Return Gᵀ p, entry node * dim + component. */
    Vector
    bar_forces(const Vector &p) const;

    /** Return the jump of every bar. */
    Vector
    jumps(const dealii::Vector<double> &u) const;

    /**
     * Return the strain energy of every cell; u is given by nodes, entry node * dim + component.
     */
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

    /** Return whether each component of a node (entry node * dim + component) is held. */
    const std::vector<bool> &
    fixed_dofs() const
    {
      return fixed;
    }

    /**
     * Return the errors of the full model for displacement u, bar forces p and nodal forces
     * @p loads (entry node * dim + component; empty: none). @p motion is a rigid motion that was
     * subtracted from u, up to whose last digits the jumps are uncertain.
     */
    EquilibriumError
    equilibrium_error_under(const Vector &loads,
                            const dealii::Vector<double> &u,
                            const Vector &p,
                            const dealii::Vector<double> &motion) const;

    /**
     * Return the errors for bodies that move, where inertia is one of the @p loads. @p u, the
     * displacement, is correct to its last digits, which may be coarser than the entire part of it
     * that K feels, the @p deformation (both by nodes). For @p acting, see
     * fuga::equilibrium_error().
     */
    EquilibriumError
    equilibrium_error_in_motion(const Vector &loads,
                                const Vector &u,
                                const Vector &deformation,
                                const Vector &p,
                                const Vector &acting) const;

    /** Return Cᵀ (P - K u) for vectors by nodes. */
    Vector
    out_of_balance(const Vector &loads, const Vector &u) const;

    /** Convert a vector by nodes to one by degrees of freedom. */
    dealii::Vector<double>
    by_degrees_of_freedom(const Vector &u) const;

    const ModelDefinition &
    definition() const
    {
      return model;
    }

    /** Return whether supports are released: inertia acts, and nothing has to hold the bodies. */
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

    /** Return the assemblies of uplifts created so far, by number of load. */
    const std::vector<std::unique_ptr<UpliftAssembly<dim>>> &
    uplift_assemblies() const
    {
      return uplifts;
    }

    /** Return the lines for the log. */
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

    /** Return time and memory of every phase so far. */
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
    /** Assemblies of uplifts by number of load, created when first needed. */
    mutable std::vector<std::unique_ptr<UpliftAssembly<dim>>> uplifts;
    std::vector<JointFace> faces;
    std::vector<std::string> lines;
    mutable PhaseTimer timer;
  };
} // namespace fuga

#endif
