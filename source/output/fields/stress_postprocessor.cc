// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/elastic_stress.h>
#include <fuga/output/fields/stress_postprocessor.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Return the principal values, the largest first. In the plane deal.II's function rejects a
     * shear whose square underflows. */
    std::array<double, 2>
    principal_values(const dealii::SymmetricTensor<2, 2> &stress)
    {
      const double mean   = 0.5 * trace(stress);
      const double radius = std::hypot(0.5 * (stress[0][0] - stress[1][1]), stress[0][1]);
      return {{mean + radius, mean - radius}};
    }

    std::array<double, 3>
    principal_values(const dealii::SymmetricTensor<2, 3> &stress)
    {
      return eigenvalues(stress);
    }
  } // namespace

  template <int dim>
  StressPostprocessor<dim>::StressPostprocessor(const ModelDefinition &model_definition,
                                                const std::vector<std::string> &body_names,
                                                const TemperatureField<dim> &temperature_field)
    : model(model_definition), temperature(temperature_field)
  {
    for (const std::string &name : body_names)
      for (const Material &material : model.materials)
        if (material.body == name)
          materials.push_back(material);
  }

  template <int dim>
  std::vector<std::string>
  StressPostprocessor<dim>::get_names() const
  {
    std::vector<std::string> names(dim * dim, "stress");
    for (unsigned int i = 1; i <= dim; ++i)
      names.push_back(fmt::format("principal_stress_{}", i));
    names.emplace_back("von_mises_stress");
    if (model.assumption == PlaneAssumption::axisymmetric)
      names.emplace_back("hoop_stress");
    return names;
  }

  template <int dim>
  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  StressPostprocessor<dim>::get_data_component_interpretation() const
  {
    using namespace dealii::DataComponentInterpretation;
    std::vector<DataComponentInterpretation> interpretation(dim * dim, component_is_part_of_tensor);
    interpretation.insert(
      interpretation.end(), get_names().size() - dim * dim, component_is_scalar);
    return interpretation;
  }

  template <int dim>
  dealii::UpdateFlags
  StressPostprocessor<dim>::get_needed_update_flags() const
  {
    dealii::UpdateFlags flags = dealii::update_gradients;
    if (model.assumption == PlaneAssumption::axisymmetric)
      flags |= dealii::update_values | dealii::update_quadrature_points;
    if (!temperature.empty())
      flags |= dealii::update_quadrature_points;
    return flags;
  }

  namespace
  {
    /** Return u_r / r, or its limit on the axis. */
    template <int dim>
    double
    hoop_strain(const dealii::DataPostprocessorInputs::Vector<dim> &inputs, const std::size_t q)
    {
      const double radius = inputs.evaluation_points[q][0];
      return radius == 0. ? inputs.solution_gradients[q][0][0]
                          : inputs.solution_values[q](0) / radius;
    }
  } // namespace

  template <int dim>
  void
  StressPostprocessor<dim>::evaluate_vector_field(
    const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &computed) const
  {
    const auto body            = inputs.template get_cell<dim>()->material_id();
    const bool is_axisymmetric = model.assumption == PlaneAssumption::axisymmetric;
    for (std::size_t q = 0; q < computed.size(); ++q)
      {
        dealii::Tensor<2, dim> gradient;
        for (unsigned int i = 0; i < dim; ++i)
          gradient[i] = inputs.solution_gradients[q][i];
        const StressState<dim> stress = elastic_stress<dim>(
          materials[body],
          model.assumption,
          gradient,
          is_axisymmetric ? hoop_strain(inputs, q) : 0.,
          temperature.empty() ? 0. : temperature.strain(inputs.evaluation_points[q], body));
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            computed[q](i * dim + j) = stress.in_plane[i][j];
        const auto principal = principal_values(stress.in_plane);
        for (unsigned int i = 0; i < dim; ++i)
          computed[q](dim * dim + i) = principal[i];
        const double a = principal[0], b = principal[dim - 1],
                     third           = dim == 2 ? stress.across : principal[1];
        computed[q](dim * dim + dim) = std::sqrt(
          0.5 * ((a - b) * (a - b) + (b - third) * (b - third) + (third - a) * (third - a)));
        if (is_axisymmetric)
          computed[q](dim * dim + dim + 1) = third;
      }
  }

  template <int dim>
  VectorOutput<dim>::VectorOutput(const std::string &of_field)
    : dealii::DataPostprocessorVector<dim>(of_field, dealii::update_values)
  {
  }

  template <int dim>
  void
  VectorOutput<dim>::evaluate_vector_field(
    const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &computed) const
  {
    for (std::size_t q = 0; q < computed.size(); ++q)
      for (unsigned int i = 0; i < dim; ++i)
        computed[q](i) = inputs.solution_values[q](i);
  }

  template class StressPostprocessor<2>;
  template class StressPostprocessor<3>;
  template class VectorOutput<2>;
  template class VectorOutput<3>;
} // namespace fuga
