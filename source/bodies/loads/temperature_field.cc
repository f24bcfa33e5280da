// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/function_parser.h>

#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/bodies/model_names.h>

namespace fuga
{
  template <int dim>
  void
  TemperatureField<dim>::add(const ModelDefinition &model,
                             const std::vector<std::string> &body_names,
                             const LoadDefinition &load,
                             const double t,
                             const double factor)
  {
    Term term;
    term.temperature =
      std::make_unique<FieldExpression<dim>>(load.expressions, model.constants, load_title(load));
    term.temperature->set_time(t);
    term.expansion.assign(body_names.size(), 0.);
    for (const Material &material : model.materials)
      if (load.targets.empty() || index_of(load.targets, material.body) < load.targets.size())
        term.expansion.at(index_of(body_names, material.body)) =
          factor * material.thermal_expansion;
    terms.push_back(std::move(term));
  }


  template <int dim>
  double
  TemperatureField<dim>::strain(const dealii::Point<dim> &point, const unsigned int body) const
  {
    double sum = 0.;
    for (const Term &term : terms)
      if (term.expansion[body] != 0.)
        sum += term.expansion[body] * term.temperature->value(point, 0);
    return sum;
  }


  template class TemperatureField<2>;
  template class TemperatureField<3>;
} // namespace fuga
