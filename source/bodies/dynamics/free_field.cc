// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/bodies/dynamics/free_field.h>
#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Places on a side that differ by less are the same, relative to the length of a face. */
    constexpr double same_place = 1e-6;
  } // namespace


  template <int dim>
  FreeField<dim>::FreeField(const BodyModel<dim> &bodies,
                            const DrivingForces<dim> &driving_forces,
                            const FreeColumn::Damping &damping)
    : model(bodies)
    , driving(driving_forces)
    , dashpots(make_dashpots(model, model.definition().dynamics.free_field.names))
  {
    const Discretization<dim> &space = model.discretization();
    const std::vector<bool> selected =
      selection(model.jointed_mesh().label_names, model.definition().dynamics.free_field.names);
    std::vector<std::vector<Face>> faces;
    for (const Face &face : space.boundary_faces(selected))
      {
        const auto is_beside = [&](const std::vector<Face> &others) {
          return std::abs(space.face_center(face)[0] - space.face_center(others.front())[0]) <
                 same_place * space.face_length(face);
        };
        const auto found = std::find_if(faces.begin(), faces.end(), is_beside);
        if (found == faces.end())
          faces.push_back({face});
        else
          found->push_back(face);
      }
    for (std::vector<Face> &of_side : faces)
      {
        std::sort(of_side.begin(), of_side.end(), [&](const Face &a, const Face &b) {
          return space.face_center(a)[1] < space.face_center(b)[1];
        });
        sides.push_back(make_side(of_side, damping));
      }
  }


  template <int dim>
  std::vector<std::size_t>
  FreeField<dim>::from_below(const Face &face) const
  {
    const Discretization<dim> &space = model.discretization();
    std::vector<std::size_t> order(space.reference_element().face(face.number).nodes.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      order[k] = k;
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
      return space.position(space.face_node(face, a))[1] <
             space.position(space.face_node(face, b))[1];
    });
    std::vector<std::size_t> nodes;
    for (const std::size_t k : order)
      nodes.push_back(space.face_node(face, k));
    return nodes;
  }


  template <int dim>
  typename FreeField<dim>::Side
  FreeField<dim>::make_side(const std::vector<Face> &faces,
                            const FreeColumn::Damping &damping) const
  {
    const Discretization<dim> &space  = model.discretization();
    const ModelDefinition &definition = model.definition();
    const JointedMesh &mesh           = model.jointed_mesh();
    const Vector density              = mass_densities(mesh, definition);
    Side side;
    std::vector<FreeColumn::Cell> cells;
    unsigned int first_node = 0;
    double top              = 0.;
    for (const Face &face : faces)
      {
        const std::vector<std::size_t> nodes = from_below(face);
        FreeColumn::Cell cell;
        cell.first_node = first_node;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          {
            cell.heights.push_back(space.position(nodes[i])[1]);
            side.nodes[static_cast<unsigned int>(nodes[i])] =
              first_node + static_cast<unsigned int>(i);
          }
        const double length = space.face_length(face);
        if (!cells.empty() && std::abs(cell.heights.front() - top) > same_place * length)
          throw InputError(fmt::format(
            "{}: a side beside a free field is of one piece from its foot to its top, but at {} "
            "faces are missing or there twice. Name all boundaries of the side.",
            definition.dynamics.free_field.origin,
            text_of(space.position(static_cast<unsigned int>(nodes.front())))));
        top = cell.heights.back();

        const Material *material = nullptr;
        for (const Material &one : definition.materials)
          if (one.body == mesh.body_names[space.cell_body(face.cell)])
            material = &one;
        const LameConstants stiff = lame_constants(*material, definition.assumption);
        cell.density              = density[space.cell_body(face.cell)];
        cell.moduli               = {{stiff.mu, stiff.lambda + 2. * stiff.mu}};
        first_node += static_cast<unsigned int>(nodes.size()) - 1;

        // A column has strains along y only: σ_xx = λ v', σ_xy = μ u'.
        Vector points;
        for (const double height : cell.heights)
          points.push_back((height - cell.heights.front()) / length);
        const LineIntegrals integrals(points);
        const double across =
          space.extent_across(space.face_center(face)) *
          FaceMap<dim>(space, face).normal(typename ReferenceElement<dim>::FacePoint())[0];
        for (std::size_t i = 0; i < nodes.size(); ++i)
          for (std::size_t j = 0; j < nodes.size(); ++j)
            for (unsigned int c = 0; c < 2; ++c)
              side.tractions.push_back(
                {nodes[i] * dim + c,
                 2 * (cell.first_node + j) + 1 - c,
                 across * (c == 0 ? stiff.lambda : stiff.mu) * integrals.slopes_by_values(i, j)});
        cells.push_back(std::move(cell));
      }
    side.column = std::make_unique<FreeColumn>(cells,
                                               foot(faces.front()),
                                               damping,
                                               definition.dynamics.spectral_radius,
                                               definition.dynamics.halvings + 1);
    return side;
  }


  template <int dim>
  FreeColumn::Foot
  FreeField<dim>::foot(const Face &lowest) const
  {
    const auto node = static_cast<unsigned int>(from_below(lowest).front());
    FreeColumn::Foot result;
    if (driving.base().count(node) > 0)
      {
        const Impedances of_ground =
          impedances(model)[model.discretization().cell_body(lowest.cell)];
        result.dashpots = {{of_ground.shear, of_ground.pressure}};
        return result;
      }
    for (unsigned int c = 0; c < 2; ++c)
      result.held[c] = model.fixed_dofs()[node * dim + c];
    if (!result.held[0] || !result.held[1])
      throw InputError(fmt::format(
        "{}: the free field has no foot: its lowest point, {}, is neither on the 'Compliant base' "
        "nor held in x and y. Let the side end at one of them.",
        model.definition().dynamics.free_field.origin,
        text_of(model.discretization().position(node))));
    return result;
  }


  template <int dim>
  FreeColumn::Drive
  FreeField<dim>::drive_at(const double time) const
  {
    const auto acceleration = driving.ground_acceleration(time);
    const auto wave         = driving.upward_wave(time);
    if (driving.base().empty())
      return {{{acceleration[0], acceleration[1]}}, {}};
    return {{}, {{wave[0], wave[1]}}};
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
    const FreeColumn::Drive drive = drive_at(time_at_end);
    Vector velocity(forces.size(), 0.);
    for (Side &side : sides)
      {
        side.column->try_step(rung, h, drive);
        const Vector strained = side.column->strained();
        for (const Traction &traction : side.tractions)
          forces[traction.dof] += traction.factor * strained[traction.of_column];
        for (const auto &[node, of_column] : side.nodes)
          for (unsigned int c = 0; c < 2; ++c)
            velocity[node * dim + c] = side.column->velocity()[2 * of_column + c];
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
