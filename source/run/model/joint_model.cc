// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/dependent_rows.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/point_text.h>
#include <fuga/contact/system/soft_bars.h>
#include <fuga/input/layer_law.h>
#include <fuga/run/model/joint_model.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace fuga
{
  namespace
  {
    /** Return the coupling of a joint whose laws are the last two of the model; a nullptr without
     * one. */
    const ShearCoupling *
    add_coupling(const JointParameters &joint, JointModel &model)
    {
      const ShearGrowth &growth = joint.shear_growth;
      if (growth.kind == ShearGrowth::Kind::none)
        return nullptr;
      const auto kind = growth.kind == ShearGrowth::Kind::closure ? ShearCoupling::Kind::closure
                                                                  : ShearCoupling::Kind::pressure;
      const ComplianceLaw &normal = *model.laws[model.laws.size() - 2];
      const ComplianceLaw &shear  = *model.laws.back();
      model.couplings.push_back(std::make_unique<ShearCoupling>(
        kind, normal, shear.initial_compliance(), growth.scale, growth.exponent));
      return model.couplings.back().get();
    }

    template <int dim>
    FieldExpression<dim>
    gap_expression(const JointParameters &joint, const std::map<std::string, double> &constants)
    {
      return {{joint.initial_gap},
              constants,
              fmt::format("{}: initial gap of joint '{}'", joint.origin, joint.definition.name)};
    }

    template <int dim>
    double
    initial_gap(const FieldExpression<dim> &expression,
                const ContactElement &element,
                const JointParameters &joint)
    {
      const double gap = expression.value(place_of<dim>(element), 0);
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

    // Gaps below this size are unknown both to coordinates in double precision and to a path that
    // considers a gap of 1e-12 of the largest one closed. Lips that are apart by so little would
    // close before any load could be a measure for them.
    void
    close_gaps_of_rounding(std::vector<ContactElement> &elements)
    {
      constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
      constexpr double closed   = 1e-12;
      double none               = 0.;
      for (const ContactElement &element : elements)
        {
          none = std::max(none, closed * element.initial_gap);
          for (const double coordinate : element.position)
            none = std::max(none, rounding * std::abs(coordinate));
        }
      for (ContactElement &element : elements)
        if (element.initial_gap <= none)
          element.initial_gap = 0.;
    }

    /** Share of the bodies' own compliance that makes the forces of repeated rigid bars unique. */
    constexpr double crossing_compliance = 1e-4;

    /** Return the smallest compliance with which bars share their forces by themselves [m/MPa]. */
    double
    smallest_compliance(const ContactElement &element, const double stiffness)
    {
      return crossing_compliance * element.area / stiffness;
    }

    bool
    is_rigid(const ContactElement &element, const bool normal, const double stiffness)
    {
      const ComplianceLaw &law = normal ? *element.normal_law : *element.shear_law;
      return law.kind() == ComplianceKind::rigid ||
             (law.kind() == ComplianceKind::linear &&
              law.initial_compliance() < smallest_compliance(element, stiffness));
    }

    std::vector<bool>
    find_rigid(const std::vector<ContactElement> &elements,
               const std::size_t n_bars,
               const double stiffness)
    {
      std::vector<bool> rigid(n_bars, false);
      for (const ContactElement &element : elements)
        for (std::size_t i = 0; i < element.n_bars(); ++i)
          rigid[element.bar(i)] = is_rigid(element, i == 0, stiffness);
      return rigid;
    }

    /** Return for every bar whether it is rigid and its jump and those of other rigid bars depend
     * on each other, so that forces in them may balance. */
    std::vector<bool>
    find_repeated(const SparseOperator &B,
                  const std::vector<ContactElement> &elements,
                  const double stiffness)
    {
      std::vector<bool> repeated(B.n_rows(), false);
      const std::vector<bool> rigid = find_rigid(elements, B.n_rows(), stiffness);
      for (const SparseBlock &block : blocks_of(B, rigid))
        {
          const std::vector<bool> dependent =
            dependent_rows(submatrix(B, block.rows, block.columns));
          for (std::size_t i = 0; i < block.rows.size(); ++i)
            repeated[block.rows[i]] = dependent[i];
        }
      return repeated;
    }

    template <int dim>
    void
    separate_repeated_bars(const CondensedSystem<dim> &system, JointModel &model)
    {
      if (system.jump_operator().is_identity())
        return;
      const double stiffness = system.has_stiffness()
                                 ? largest_diagonal(system.stiffness())
                                 : max_abs(system.elastic_bodies().node_moduli());
      const std::vector<bool> repeated =
        find_repeated(system.jump_operator(), model.elements, stiffness);
      std::vector<dealii::Point<dim>> places;
      double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
      for (ContactElement &element : model.elements)
        {
          const bool normal = repeated[element.normal_bar];
          const bool shear =
            (element.has_tangential_bar() && repeated[element.tangential_bar]) ||
            (element.has_second_tangential_bar() && repeated[element.second_tangential_bar]);
          if (!normal && !shear)
            continue;
          const double compliance = smallest_compliance(element, stiffness);
          model.laws.push_back(make_linear_law(compliance));
          if (normal)
            element.normal_law = model.laws.back().get();
          if (shear)
            element.shear_law = model.laws.back().get();
          smallest = std::min(smallest, compliance);
          largest  = std::max(largest, compliance);
          places.push_back(place_of<dim>(element));
        }
      if (!places.empty())
        model.report.push_back(fmt::format(
          "rigid, or almost rigid, joints cross or have corners at {}: the {} elements there get "
          "compliances from {:.3g} to {:.3g}, so that their forces are unique",
          text_of_first(places),
          places.size(),
          smallest,
          largest));
    }
  } // namespace

  template <int dim>
  JointModel
  make_joint_model(const CondensedSystem<dim> &bodies,
                   const std::vector<JointParameters> &joints,
                   const std::map<std::string, double> &constants)
  {
    JointModel model;
    model.elements = bodies.elements();
    for (unsigned int j = 0; j < joints.size(); ++j)
      {
        const JointParameters &joint = joints[j];
        for (const LayerDirection direction : {LayerDirection::normal, LayerDirection::shear})
          model.laws.push_back(make_layer_law(joint, direction, constants));
        const ShearCoupling *const coupling = add_coupling(joint, model);
        const FieldExpression<dim> gap      = gap_expression<dim>(joint, constants);
        for (ContactElement &element : model.elements)
          if (element.joint == j)
            {
              element.coupling    = element.has_tangential_bar() ? coupling : nullptr;
              element.normal_law  = model.laws[2 * j].get();
              element.shear_law   = model.laws[2 * j + 1].get();
              element.friction    = joint.friction;
              element.initial_gap = initial_gap(gap, element, joint);
            }
      }
    close_gaps_of_rounding(model.elements);
    separate_repeated_bars<dim>(bodies, model);
    return model;
  }

  template <int dim>
  void
  check_initial_gaps(const std::vector<ContactElement> &elements,
                     const std::vector<JointParameters> &joints,
                     const std::map<std::string, double> &constants)
  {
    for (unsigned int j = 0; j < joints.size(); ++j)
      {
        const FieldExpression<dim> gap = gap_expression<dim>(joints[j], constants);
        for (const ContactElement &element : elements)
          if (element.joint == j)
            initial_gap(gap, element, joints[j]);
      }
  }

  template JointModel
  make_joint_model<2>(const CondensedSystem<2> &,
                      const std::vector<JointParameters> &,
                      const std::map<std::string, double> &);
  template void
  check_initial_gaps<2>(const std::vector<ContactElement> &,
                        const std::vector<JointParameters> &,
                        const std::map<std::string, double> &);
  template JointModel
  make_joint_model<3>(const CondensedSystem<3> &,
                      const std::vector<JointParameters> &,
                      const std::map<std::string, double> &);
  template void
  check_initial_gaps<3>(const std::vector<ContactElement> &,
                        const std::vector<JointParameters> &,
                        const std::map<std::string, double> &);
} // namespace fuga
