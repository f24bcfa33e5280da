// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/geometric_stiffness.h>
#include <fuga/bodies/elasticity/elastic_stress.h>
#include <fuga/bodies/space/cell_values.h>

namespace fuga
{
  namespace
  {
    /** Computes the stresses of one cell after the other. */
    template <int dim>
    class CellStresses
    {
    public:
      CellStresses(const CondensedSystem<dim> &bodies,
                   const Vector &displacement,
                   const TemperatureField<dim> &temperature_field)
        : space(bodies.discretization())
        , assumption(bodies.definition().assumption)
        , temperature(temperature_field)
        , is_axisymmetric(space.is_axisymmetric())
      {
        for (const std::string &name : bodies.jointed_mesh().body_names)
          for (const Material &material : bodies.definition().materials)
            if (material.body == name)
              {
                materials.push_back(&material);
                straining.push_back(
                  space.by_nodes(bodies.straining(displacement, material.built_at)));
              }
      }

      StressState<dim>
      at(const CellValues<dim> &values, const std::size_t cell, const std::size_t q) const
      {
        const unsigned int body = space.cell_body(cell);
        dealii::Tensor<2, dim> gradient;
        double radial = 0.;
        for (std::size_t a = 0; a < space.reference_element().n_nodes(); ++a)
          {
            const double *u = straining[body].data() + space.cell_nodes(cell)[a] * dim;
            for (unsigned int c = 0; c < dim; ++c)
              gradient[c] += u[c] * values.gradient(a, q);
            radial += u[0] * values.value(a, q);
          }
        const dealii::Point<dim> point = values.point(q);
        return elastic_stress<dim>(*materials[body],
                                   assumption,
                                   gradient,
                                   is_axisymmetric ? radial / point[0] : 0.,
                                   temperature.empty() ? 0. : temperature.strain(point, body));
      }

    private:
      const Discretization<dim> &space;
      const PlaneAssumption assumption;
      const TemperatureField<dim> &temperature;
      const bool is_axisymmetric;
      /** The material of each body, and the displacement that strains the body, by nodes. */
      std::vector<const Material *> materials;
      std::vector<Vector> straining;
    };
  } // namespace

  template <int dim>
  void
  add_geometric_stiffness(const CondensedSystem<dim> &bodies,
                          const Vector &displacement,
                          const TemperatureField<dim> &temperature,
                          dealii::SparseMatrix<double> &matrix)
  {
    if (displacement.empty())
      return;
    const Discretization<dim> &space = bodies.discretization();
    const std::size_t n_nodes        = space.reference_element().n_nodes();
    const CellStresses<dim> stresses(bodies, displacement, temperature);
    CellValues<dim> values(space);
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      {
        if (!space.is_own(cell))
          continue;
        values.move_to(cell);
        const unsigned int *nodes = space.cell_nodes(cell);
        for (std::size_t q = 0; q < values.n_points(); ++q)
          {
            const StressState<dim> stress = stresses.at(values, cell, q);
            const double volume           = values.volume(q);
            for (std::size_t a = 0; a < n_nodes; ++a)
              {
                const dealii::Tensor<1, dim> traction = stress.in_plane * values.gradient(a, q);
                for (std::size_t b = 0; b < n_nodes; ++b)
                  {
                    const double value = volume * (traction * values.gradient(b, q));
                    for (unsigned int c = 0; c < dim; ++c)
                      matrix.add(nodes[a] * dim + c, nodes[b] * dim + c, value);
                    if (space.is_axisymmetric())
                      matrix.add(nodes[a] * dim,
                                 nodes[b] * dim,
                                 volume * stress.across * values.value(a, q) * values.value(b, q) /
                                   (values.point(q)[0] * values.point(q)[0]));
                  }
              }
          }
      }
  }

  template void
  add_geometric_stiffness(const CondensedSystem<2> &,
                          const Vector &,
                          const TemperatureField<2> &,
                          dealii::SparseMatrix<double> &);
  template void
  add_geometric_stiffness(const CondensedSystem<3> &,
                          const Vector &,
                          const TemperatureField<3> &,
                          dealii::SparseMatrix<double> &);
} // namespace fuga
