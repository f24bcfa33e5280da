// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/stress_postprocessor.h>

#include <cmath>

namespace fuga
{
  template <int dim>
  StressPostprocessor<dim>::StressPostprocessor(const ModelDefinition &model_definition,
                                                const std::vector<std::string> &body_names)
    : model(model_definition)
  {
    for (const std::string &name : body_names)
      for (const Material &material : model.materials)
        if (material.body == name)
          {
            materials.push_back(lame_constants(material, model.assumption));
            poisson_ratios.push_back(material.poisson_ratio);
          }
  }

  template <int dim>
  std::vector<std::string>
  StressPostprocessor<dim>::get_names() const
  {
    std::vector<std::string> names(dim * dim, "stress");
    names.insert(names.end(), {"principal_stress_1", "principal_stress_2", "von_mises_stress"});
    return names;
  }

  template <int dim>
  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  StressPostprocessor<dim>::get_data_component_interpretation() const
  {
    using namespace dealii::DataComponentInterpretation;
    std::vector<DataComponentInterpretation> interpretation(dim * dim, component_is_part_of_tensor);
    interpretation.insert(interpretation.end(), 3, component_is_scalar);
    return interpretation;
  }

  template <int dim>
  dealii::UpdateFlags
  StressPostprocessor<dim>::get_needed_update_flags() const
  {
    return dealii::update_gradients;
  }

  template <int dim>
  void
  StressPostprocessor<dim>::evaluate_vector_field(
    const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &computed) const
  {
    const auto body           = inputs.template get_cell<dim>()->material_id();
    const LameConstants &lame = materials[body];
    const bool strain         = model.assumption == PlaneAssumption::plane_strain;
    for (std::size_t q = 0; q < computed.size(); ++q)
      {
        dealii::SymmetricTensor<2, dim> epsilon;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            epsilon[i][j] =
              0.5 * (inputs.solution_gradients[q][i][j] + inputs.solution_gradients[q][j][i]);
        const dealii::SymmetricTensor<2, dim> sigma =
          lame.lambda * trace(epsilon) * dealii::unit_symmetric_tensor<dim>() +
          2. * lame.mu * epsilon;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            computed[q](i * dim + j) = sigma[i][j];
        const auto principal = eigenvalues(sigma);
        const double across  = strain ? poisson_ratios[body] * trace(sigma) : 0.;
        const double a = principal[0], b = principal[dim - 1];
        computed[q](dim * dim)     = a;
        computed[q](dim * dim + 1) = b;
        computed[q](dim * dim + 2) = std::sqrt(
          0.5 * ((a - b) * (a - b) + (b - across) * (b - across) + (across - a) * (across - a)));
      }
  }

  template <int dim>
  DisplacementOutput<dim>::DisplacementOutput()
    : dealii::DataPostprocessorVector<dim>("displacement", dealii::update_values)
  {
  }

  template <int dim>
  void
  DisplacementOutput<dim>::evaluate_vector_field(
    const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &computed) const
  {
    for (std::size_t q = 0; q < computed.size(); ++q)
      for (unsigned int i = 0; i < dim; ++i)
        computed[q](i) = inputs.solution_values[q](i);
  }

  template class StressPostprocessor<2>;
  template class DisplacementOutput<2>;
} // namespace fuga
