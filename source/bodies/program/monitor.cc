// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/elastic_stress.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/program/monitor.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the linear response from which the work of a force on the displacement follows. */
    template <int dim>
    LinearResponse
    response(const CondensedSystem<dim> &system, const Vector &force, const Monitor::Source source)
    {
      if (source == Monitor::Source::loads)
        return system.response(force);
      return {force, Vector(system.load_patterns().cols(), 0.)};
    }

    /** Return the response of the displacement that strains a body: without the shape in which it
     * is free of stress, which acts together with the carried load, the last but one of the
     * patterns. */
    template <int dim>
    LinearResponse
    straining(const CondensedSystem<dim> &system,
              const Vector &force,
              const Material &material,
              const Monitor::Source source)
    {
      LinearResponse result = response(system, force, source);
      const double free     = system.stress_free_value(force, material.built_at);
      if (free != 0.)
        result.patterns[result.patterns.size() - 2] -= free;
      return result;
    }
  } // namespace

  template <int dim>
  Monitor::Monitor(const MonitorDefinition &definition,
                   const MonitorPoint<dim> &point,
                   const ModelDefinition &model,
                   const CondensedSystem<dim> &system,
                   const Source source)
    : its_name(definition.name), its_body(point.body()), assumption(model.assumption)
  {
    for (const Material &candidate : model.materials)
      if (index_of(system.jointed_mesh().body_names, candidate.body) == its_body)
        material = candidate;
    for (unsigned int i = 0; i < dim; ++i)
      {
        its_position[i] = point.position()[i];
        components.push_back(response(system, point.unit_force(i), source));
        for (unsigned int j = 0; definition.stress && j < dim; ++j)
          gradient.push_back(straining(system, point.gradient_force(i, j), material, source));
      }
    if (definition.stress && assumption == PlaneAssumption::axisymmetric)
      radial = straining(system, point.unit_force(0), material, source);
  }

  std::array<double, 3>
  Monitor::displacement(const Vector &x, const Vector &a) const
  {
    std::array<double, 3> u{};
    for (std::size_t c = 0; c < components.size(); ++c)
      u[c] = components[c].value(x, a);
    return u;
  }

  std::array<double, 3>
  Monitor::value_of(const Vector &field) const
  {
    std::array<double, 3> value{};
    for (std::size_t c = 0; c < components.size(); ++c)
      value[c] = dot(components[c].coordinates, field);
    return value;
  }

  std::vector<unsigned int>
  Monitor::watched_dofs() const
  {
    std::vector<unsigned int> result;
    const auto add = [&result](const LinearResponse &response) {
      for (unsigned int dof = 0; dof < response.coordinates.size(); ++dof)
        if (response.coordinates[dof] != 0.)
          result.push_back(dof);
    };
    std::for_each(components.begin(), components.end(), add);
    std::for_each(gradient.begin(), gradient.end(), add);
    add(radial);
    return result;
  }

  std::array<double, 6>
  Monitor::stress(const Vector &x, const Vector &a, const double thermal_strain) const
  {
    if (gradient.empty())
      {
        std::array<double, 6> none;
        none.fill(std::numeric_limits<double>::quiet_NaN());
        return none;
      }
    return components.size() == 2 ? stress_in<2>(x, a, thermal_strain)
                                  : stress_in<3>(x, a, thermal_strain);
  }

  template <int dim>
  std::array<double, 6>
  Monitor::stress_in(const Vector &x, const Vector &a, const double thermal_strain) const
  {
    dealii::Tensor<2, dim> du;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        du[i][j] = gradient[dim * i + j].value(x, a);
    double hoop = 0.;
    if (assumption == PlaneAssumption::axisymmetric)
      hoop = its_position[0] == 0. ? du[0][0] : radial.value(x, a) / its_position[0];
    const StressState<dim> state =
      elastic_stress<dim>(material, assumption, du, hoop, thermal_strain);
    const auto &s = state.in_plane;
    if constexpr (dim == 2)
      return {{s[0][0], s[1][1], state.across, s[0][1], 0., 0.}};
    else
      return {{s[0][0], s[1][1], s[2][2], s[0][1], s[0][2], s[1][2]}};
  }

  template Monitor::Monitor(const MonitorDefinition &,
                            const MonitorPoint<2> &,
                            const ModelDefinition &,
                            const CondensedSystem<2> &,
                            const Source);
  template Monitor::Monitor(const MonitorDefinition &,
                            const MonitorPoint<3> &,
                            const ModelDefinition &,
                            const CondensedSystem<3> &,
                            const Source);
} // namespace fuga
