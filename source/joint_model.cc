// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/joint_model.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    std::unique_ptr<ComplianceLaw>
    make_law(const LayerLaw law, const double compliance, const double thickness)
    {
      switch (law)
        {
          case LayerLaw::rigid:
            return make_rigid_law();
          case LayerLaw::linear:
            return make_linear_law(compliance);
          case LayerLaw::cubic_root:
            return make_cubic_root_law(compliance, thickness);
        }
      return nullptr;
    }

    template <int dim>
    double
    initial_gap(const FieldExpression<dim> &expression,
                const ContactElement &element,
                const JointParameters &joint)
    {
      dealii::Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = element.position[d];
      const double gap = expression.value(point, 0);
      if (gap < 0.)
        throw InputError(fmt::format(
          "{}: the initial gap '{}' of joint '{}' is {:g} at ({}). A gap is not negative: "
          "use max(0, ...) if the formula dips below zero.",
          joint.origin,
          joint.initial_gap,
          joint.definition.name,
          gap,
          fmt::join(element.position, ", ")));
      return gap;
    }
  } // namespace

  template <int dim>
  JointModel
  make_joint_model(const std::vector<ContactElement> &geometry,
                   const std::vector<JointParameters> &joints,
                   const std::map<std::string, double> &constants)
  {
    JointModel model;
    model.elements = geometry;
    for (unsigned int j = 0; j < joints.size(); ++j)
      {
        const JointParameters &joint = joints[j];
        model.laws.push_back(make_law(joint.normal_law, joint.normal_compliance, joint.thickness));
        model.laws.push_back(make_law(joint.shear_law, joint.shear_compliance, joint.thickness));
        const FieldExpression<dim> gap(
          {joint.initial_gap},
          constants,
          fmt::format("{}: initial gap of joint '{}'", joint.origin, joint.definition.name));
        for (ContactElement &element : model.elements)
          if (element.joint == j)
            {
              element.normal_law  = model.laws[2 * j].get();
              element.shear_law   = model.laws[2 * j + 1].get();
              element.friction    = joint.friction;
              element.initial_gap = initial_gap(gap, element, joint);
            }
      }
    return model;
  }

  template JointModel
  make_joint_model<2>(const std::vector<ContactElement> &,
                      const std::vector<JointParameters> &,
                      const std::map<std::string, double> &);
} // namespace fuga
