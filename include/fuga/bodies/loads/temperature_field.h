// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_temperature_field_h
#define fuga_bodies_loads_temperature_field_h

#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** The thermal strain αΔT of the bodies: a sum of temperature loads with factors. */
  template <int dim>
  class TemperatureField
  {
  public:
    /** Create a field without change of temperature. */
    TemperatureField() = default;

    /**
     * Add @p factor times the change of temperature of @p load (which is a temperature load) at
     * load time @p t. @throws InputError for an expression that cannot be evaluated.
     * @throws InputError for an expression that cannot be evaluated.
     */
    void
    add(const ModelDefinition &model,
        const std::vector<std::string> &body_names,
        const LoadDefinition &load,
        const double t,
        const double factor);

    bool
    empty() const
    {
      return terms.empty();
    }

    double
    strain(const dealii::Point<dim> &point, const unsigned int body) const;

  private:
    struct Term
    {
      std::unique_ptr<FieldExpression<dim>> temperature;
      /** Factor times α of every body named by the load. */
      std::vector<double> expansion;
    };

    std::vector<Term> terms;
  };
} // namespace fuga

#endif
