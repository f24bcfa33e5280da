// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_load_assembly_h
#define fuga_bodies_loads_load_assembly_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/loads/water_line.h>
#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  template <int dim>
  class FieldExpression;

  /** The effect of a load on the bodies; entry node * dim + component. */
  struct LoadPattern
  {
    /** Nodal forces. */
    Vector forces;
    /** Displacements of held degrees of freedom; empty if nothing is moved. */
    Vector prescribed;
    /**
     * For water in joints, the forces per bar that press the two sides apart: those in the closed
     * joint (contained in `forces`), and the additional ones if all of it were a crack connected
     * with the reservoir. Empty for other loads, the latter also if water does not follow the
     * opening.
     */
    Vector closed_water = {}, opening_water = {};
    /** For water that follows the opening, the number of the load, and both levels. */
    std::size_t number_of_load = 0;
    WaterLevels levels         = {};
    /** Imposed jumps of the bars [m]; empty if there are none. */
    Vector jumps = {};
  };

  /** Return "file:line: Load 'name'", for messages. */
  std::string
  load_title(const LoadDefinition &load);

  /** Return whether the pattern of a load changes with the load time. */
  bool
  depends_on_time(const LoadDefinition &load);

  /** Converts load definitions to nodal forces and displacements. */
  template <int dim>
  class LoadAssembly
  {
  public:
    LoadAssembly(const Discretization<dim> &discretization,
                 const JointedMesh &mesh,
                 const ModelDefinition &model,
                 const std::vector<bool> &fixed);

    /**
     * Return the pattern of a load at load time @p t.
     * @throws InputError for expressions that cannot be evaluated or are too many or too few, for
     * points that do not exist or are not unique, for loads without target.
     */
    LoadPattern
    assemble(const LoadDefinition &load, const double t) const;

  private:
    void
    add_weight(const LoadDefinition &load,
               const FieldExpression<dim> &direction,
               Vector &forces) const;

    /**
     * Add ∫ ∇N (3λ + 2μ) αΔT (and N/r of it around the axis): the forces that would restrain the
     * bodies, with the opposite sign.
     */
    void
    add_temperature(const LoadDefinition &load, const double t, Vector &forces) const;

    /** Add a pressure (one component, against the outer normal) or a traction. */
    void
    add_surface_load(const LoadDefinition &load,
                     const FieldExpression<dim> &intensity,
                     Vector &forces) const;

    void
    add_point_force(const LoadDefinition &load,
                    const FieldExpression<dim> &force,
                    Vector &forces) const;

    unsigned int
    node_at(const LoadDefinition &load) const;

    void
    set_displacement(const LoadDefinition &load,
                     const FieldExpression<dim> &displacement,
                     Vector &prescribed) const;

    const Discretization<dim> &discretization;
    const JointedMesh &mesh;
    const ModelDefinition &model;
    const std::vector<bool> &fixed;
  };
} // namespace fuga

#endif
