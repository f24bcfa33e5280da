// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/loads/imposed_gap.h>
#include <fuga/bodies/model_names.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  Vector
  imposed_gap(const LoadDefinition &load,
              const std::map<std::string, double> &constants,
              const double t,
              const JointedMesh &mesh,
              const ContactBars<dim> &bars)
  {
    FieldExpression<dim> value(load.expressions, constants, load_title(load));
    value.set_time(t);
    Vector jumps(bars.bars().size(), 0.);
    for (const ContactElement &element : bars.elements())
      {
        if (index_of(load.targets, mesh.joints[element.joint].name) == load.targets.size())
          continue;
        dealii::Point<dim> point;
        for (unsigned int c = 0; c < dim; ++c)
          point[c] = element.position[c];
        jumps[element.normal_bar] = value.value(point, 0);
      }
    return jumps;
  }


  DenseMatrix
  imposed_jumps_of(const std::vector<LoadPattern> &patterns, const std::size_t n_bars)
  {
    if (std::all_of(
          patterns.begin(), patterns.end(), [](const auto &p) { return p.jumps.empty(); }))
      return {};
    DenseMatrix E(n_bars, patterns.size());
    for (std::size_t j = 0; j < patterns.size(); ++j)
      E.col(j).head(patterns[j].jumps.size()) = view(patterns[j].jumps);
    return E;
  }


  template Vector
  imposed_gap(const LoadDefinition &,
              const std::map<std::string, double> &,
              const double,
              const JointedMesh &,
              const ContactBars<2> &);
  template Vector
  imposed_gap(const LoadDefinition &,
              const std::map<std::string, double> &,
              const double,
              const JointedMesh &,
              const ContactBars<3> &);
} // namespace fuga
