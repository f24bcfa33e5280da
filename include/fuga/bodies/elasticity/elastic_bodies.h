// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_elastic_bodies_h
#define fuga_bodies_elasticity_elastic_bodies_h

#include <deal.II/lac/sparse_matrix.h>

#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/joints/interface_coordinates.h>
#include <fuga/bodies/solvers/interior_solver.h>

namespace fuga
{
  template <int dim>
  class NodeGraph;

  /**
   * The stiffness of the elastic bodies. No global matrix in nodal displacements is ever stored:
   * the matrix in the coordinates is assembled directly into MUMPS' triplets, and products with it
   * (residuals, energies, reactions) are sums over cells. Vectors have entries node * dim +
   * component. Every process computes on its own cells and all have to call the functions alike;
   * sums are the same on all.
   */
  template <int dim>
  class ElasticBodies
  {
  public:
    ElasticBodies(const Discretization<dim> &discretization,
                  const JointedMesh &mesh,
                  const ModelDefinition &model);

    /** Return for each node the largest modulus λ + 2μ of the bodies there [MPa]. */
    Vector
    node_moduli() const;

    /** Return one triangle of Cᵀ K C with C of @p coordinates, for the own cells. */
    SymmetricTriplets
    assemble(const InterfaceCoordinates<dim> &coordinates) const;

    /**
     * Assemble K by degrees of freedom, for the own cells; @p pattern must live as long as
     * @p matrix.
     */
    void
    assemble_by_nodes(dealii::SparsityPattern &pattern, dealii::SparseMatrix<double> &matrix) const;

    /**
     * Return K u: the nodal forces that hold the displacement u; of all bodies, or of those marked
     * in @p only by their numbers.
     */
    Vector
    forces(const Vector &u, const std::vector<bool> *only = nullptr) const;

    /**
     * Return K u, and in @p terms Σ|Kᵢⱼwⱼ|, to which the rounding errors of forces and
     * displacements are proportional if u was computed from displacements w, @p rounded.
     */
    Vector
    forces(const Vector &u, const Vector &rounded, Vector &terms) const;

    /** Return the strain energy ½ uᵀ K u of every cell. */
    Vector
    cell_energies(const Vector &u) const;

  private:
    /**
     * Call @p action(cell, u of the cell without its rigid motion, forces, stiffness) for every own
     * cell, or only for those of some bodies.
     */
    template <typename Action>
    void
    for_each_cell_force(const Vector &u,
                        const Action &action,
                        const std::vector<bool> *only = nullptr) const;

    void
    add_plain_cells(const NodeGraph<dim> &graph,
                    const std::vector<std::size_t> &cells,
                    const InterfaceCoordinates<dim> &coordinates,
                    SymmetricTriplets &matrix) const;

    void
    add_special_cells(const std::vector<std::size_t> &cells,
                      const InterfaceCoordinates<dim> &coordinates,
                      SymmetricTriplets &matrix) const;

    const Discretization<dim> &discretization;
    std::vector<LameConstants> materials;
  };
} // namespace fuga

#endif
