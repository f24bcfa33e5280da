// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/bodies/dynamics/free_field.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  FreeField<dim>::FreeField(const BodyModel<dim> &bodies,
                            const DrivingForces<dim> &driving_forces,
                            const typename FreeColumn<dim>::Damping &damping)
    : model(bodies)
    , driving(driving_forces)
    , dashpots(make_dashpots(model, model.definition().dynamics.free_field.names))
  {
    for (const SideOfGround<dim> &faces : sides_of_ground(model))
      sides.push_back(make_side(faces, damping));
  }


  template <int dim>
  typename FreeField<dim>::Side
  FreeField<dim>::make_side(const SideOfGround<dim> &faces,
                            const typename FreeColumn<dim>::Damping &damping) const
  {
    const Discretization<dim> &space  = model.discretization();
    const ModelDefinition &definition = model.definition();
    const auto cells                  = ground_beside(model, faces);
    Side side;
    side.column = std::make_unique<FreeColumn<dim>>(cells,
                                                    definition.polynomial_degree,
                                                    foot(faces),
                                                    damping,
                                                    definition.dynamics.spectral_radius,
                                                    definition.dynamics.halvings + 1);
    for (const auto &face : faces)
      {
        for (std::size_t k = 0; k < FaceMap<dim>(space, face).n_nodes(); ++k)
          if (const unsigned int node = space.face_node(face, k); side.nodes.count(node) == 0)
            side.nodes[node] = side.column->place(space.position(node)[dim - 1]);
        add_tractions(face, side);
      }
    return side;
  }


  // A column has strains along the vertical v only: t_c = λ n_c u_v' across it, t_v = μ n_c u_c'
  // along it.
  template <int dim>
  void
  FreeField<dim>::add_tractions(const typename Discretization<dim>::BoundaryFace &face,
                                Side &side) const
  {
    constexpr unsigned int v         = dim - 1;
    const Discretization<dim> &space = model.discretization();
    const FaceMap<dim> map(space, face);
    const auto &table = space.reference_element().face(face.number);
    for (std::size_t q = 0; q < table.points.size(); ++q)
      {
        const auto place  = side.column->place(map.point(table.points[q])[v]);
        const auto normal = map.normal(table.points[q]);
        const double area = table.weight[q] * map.density(table.points[q]);
        for (std::size_t k = 0; k < table.nodes.size(); ++k)
          for (std::size_t j = 0; j < place.slopes.size(); ++j)
            for (unsigned int c = 0; c < v; ++c)
              {
                const std::size_t dof       = space.face_node(face, k) * dim,
                                  of_column = dim * (place.first_node + j);
                const double factor = area * table.values[q][k] * place.slopes[j] * normal[c];
                side.tractions.push_back({dof + c, of_column + v, factor * place.cell->lambda});
                side.tractions.push_back({dof + v, of_column + c, factor * place.cell->mu});
              }
      }
  }


  template <int dim>
  typename FreeColumn<dim>::Foot
  FreeField<dim>::foot(const SideOfGround<dim> &faces) const
  {
    const Discretization<dim> &space = model.discretization();
    const Heights of_side            = heights_of(model, faces);
    typename FreeColumn<dim>::Foot result;
    for (const auto &face : faces)
      for (std::size_t k = 0; k < FaceMap<dim>(space, face).n_nodes(); ++k)
        {
          constexpr double same_place = 1e-6;
          const unsigned int node     = space.face_node(face, k);
          if (space.position(node)[dim - 1] - of_side.foot > same_place * of_side.length())
            continue;
          if (driving.base().count(node) > 0)
            {
              const Impedances of_ground = impedances(model)[space.cell_body(face.cell)];
              result.dashpots.fill(of_ground.shear);
              result.dashpots[dim - 1] = of_ground.pressure;
              continue;
            }
          for (unsigned int c = 0; c < dim; ++c)
            if (!model.fixed_dofs()[node * dim + c])
              throw InputError(
                fmt::format("{}: the free field has no foot: its lowest point, {}, is neither on "
                            "the 'Compliant "
                            "base' nor held in all directions. Let the side end at one of them.",
                            model.definition().dynamics.free_field.origin,
                            text_of(space.position(node))));
          result.held.fill(true);
        }
    return result;
  }


  template <int dim>
  typename FreeColumn<dim>::Drive
  FreeField<dim>::drive_at(const double time) const
  {
    typename FreeColumn<dim>::Drive result;
    if (!driving.base().empty())
      result.wave = driving.upward_wave(time);
    else
      for (unsigned int c = 0; c < dim; ++c)
        result.acceleration[c] = driving.ground_acceleration(time)[c];
    return result;
  }


  template <int dim>
  void
  FreeField<dim>::begin()
  {
    for (Side &side : sides)
      side.column->begin(drive_at(0.));
  }


  template <int dim>
  void
  FreeField<dim>::try_step(const unsigned int rung,
                           const double h,
                           const double time_at_end,
                           Vector &forces)
  {
    const auto drive = drive_at(time_at_end);
    Vector velocity(forces.size(), 0.);
    for (Side &side : sides)
      {
        side.column->try_step(rung, h, drive);
        const Vector strained = side.column->strained();
        for (const Traction &traction : side.tractions)
          forces[traction.dof] += traction.factor * strained[traction.of_column];
        const Vector &of_column = side.column->velocity();
        for (const auto &[node, place] : side.nodes)
          for (unsigned int c = 0; c < dim; ++c)
            {
              velocity[node * dim + c] = 0.;
              for (std::size_t i = 0; i < place.values.size(); ++i)
                velocity[node * dim + c] +=
                  place.values[i] * of_column[dim * (place.first_node + i) + c];
            }
      }
    add_dashpot_forces(1., dashpots, velocity, forces);
  }


  template <int dim>
  void
  FreeField<dim>::finish_step()
  {
    for (Side &side : sides)
      side.column->finish_step();
  }


  template <int dim>
  void
  FreeField<dim>::remember(std::vector<IntegrationMemory> &integrations) const
  {
    for (const Side &side : sides)
      integrations.push_back(side.column->integration());
  }


  template <int dim>
  void
  FreeField<dim>::restore(const std::vector<IntegrationMemory> &integrations, const double time)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
      sides[i].column->restore(integrations.at(1 + i), drive_at(time));
  }


  template class FreeField<2>;
  template class FreeField<3>;
} // namespace fuga
