// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/dashpots.h>
#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/space/face_map.h>

#include <cmath>

namespace fuga
{
  template <int dim>
  std::vector<Impedances>
  impedances(const BodyModel<dim> &model)
  {
    const ModelDefinition &definition = model.definition();
    const JointedMesh &mesh           = model.jointed_mesh();
    const Vector density              = mass_densities(mesh, definition);
    std::vector<Impedances> result(density.size());
    for (const Material &material : definition.materials)
      {
        const unsigned int body   = index_of(mesh.body_names, material.body);
        const LameConstants stiff = lame_constants(material, definition.assumption);
        result[body]              = {std::sqrt(density[body] * (stiff.lambda + 2. * stiff.mu)),
                                     std::sqrt(density[body] * stiff.mu)};
      }
    return result;
  }


  template <int dim>
  Dashpots<dim>
  make_dashpots(const BodyModel<dim> &model, const std::vector<std::string> &boundaries)
  {
    const Discretization<dim> &space        = model.discretization();
    const std::vector<Impedances> of_bodies = impedances(model);
    const std::vector<bool> selected = selection(model.jointed_mesh().label_names, boundaries);
    Dashpots<dim> result;
    for (const auto &face : space.boundary_faces(selected))
      {
        const Impedances &of_body = of_bodies[space.cell_body(face.cell)];
        const FaceMap<dim> map(space, face);
        const auto &table = space.reference_element().face(face.number);
        for (std::size_t q = 0; q < table.points.size(); ++q)
          {
            const double area = table.weight[q] * map.density(table.points[q]);
            const auto normal = map.normal(table.points[q]);
            dealii::SymmetricTensor<2, dim> per_area;
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d <= c; ++d)
                per_area[c][d] = (c == d ? of_body.shear : 0.) +
                                 (of_body.pressure - of_body.shear) * normal[c] * normal[d];
            for (std::size_t k = 0; k < table.nodes.size(); ++k)
              result[space.face_node(face, k)] += area * table.values[q][k] * per_area;
          }
      }
    return result;
  }


  template <int dim>
  void
  add_dashpot_forces(const double factor,
                     const Dashpots<dim> &dashpots,
                     const Vector &v,
                     Vector &forces)
  {
    for (const auto &[node, dashpot] : dashpots)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          forces[node * dim + c] += factor * dashpot[c][d] * v[node * dim + d];
  }


  template std::vector<Impedances>
  impedances(const BodyModel<2> &);
  template std::vector<Impedances>
  impedances(const BodyModel<3> &);
  template Dashpots<2>
  make_dashpots(const BodyModel<2> &, const std::vector<std::string> &);
  template Dashpots<3>
  make_dashpots(const BodyModel<3> &, const std::vector<std::string> &);
  template void
  add_dashpot_forces(const double, const Dashpots<2> &, const Vector &, Vector &);
  template void
  add_dashpot_forces(const double, const Dashpots<3> &, const Vector &, Vector &);
} // namespace fuga
