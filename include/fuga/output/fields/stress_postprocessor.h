// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_fields_stress_postprocessor_h
#define fuga_output_fields_stress_postprocessor_h

#include <fuga/bodies/loads/temperature_field.h>

#include <deal.II/numerics/data_postprocessor.h>

namespace fuga
{
  /**
   * Stresses of the bodies at the corners of every cell (not averaged between cells): the tensor
   * "stress", "principal_stress_1" ≥ "principal_stress_2" in the plane (≥ "principal_stress_3" in
   * space), and "von_mises_stress", which includes the stress across the plane in plane strain; in
   * axisymmetry also "hoop_stress". Tension is positive.
   */
  template <int dim>
  class StressPostprocessor : public dealii::DataPostprocessor<dim>
  {
  public:
    /**
     * Stresses are computed from the strain minus the thermal strain. All arguments must outlive
     * this object.
     */
    StressPostprocessor(const ModelDefinition &model,
                        const std::vector<std::string> &body_names,
                        const TemperatureField<dim> &temperature);

    void
    evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
                          std::vector<dealii::Vector<double>> &computed) const override;

    std::vector<std::string>
    get_names() const override;

    std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
    get_data_component_interpretation() const override;

    dealii::UpdateFlags
    get_needed_update_flags() const override;

  private:
    const ModelDefinition &model;
    const TemperatureField<dim> &temperature;
    std::vector<Material> materials;
  };

  /** Outputs the components of a field as one vector. */
  template <int dim>
  class VectorOutput : public dealii::DataPostprocessorVector<dim>
  {
  public:
    explicit VectorOutput(const std::string &name);

    void
    evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim> &inputs,
                          std::vector<dealii::Vector<double>> &computed) const override;
  };
} // namespace fuga

#endif
