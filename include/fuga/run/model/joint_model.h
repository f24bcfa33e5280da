// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_joint_model_h
#define fuga_run_model_joint_model_h

#include <deal.II/base/point.h>

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/contact/contact_element.h>
#include <fuga/input/parameters.h>

#include <memory>

namespace fuga
{
  /** Contact elements with the laws of their joints, which they point to. */
  struct JointModel
  {
    /** Normal and shear law of every joint: entries 2j and 2j + 1; then those of single elements.
     */
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    /** Of joints whose shear stiffness grows; they use the laws above. */
    std::vector<std::unique_ptr<ShearCoupling>> couplings;
    std::vector<ContactElement> elements;
    /** Lines for the log. */
    std::vector<std::string> report;
  };

  /**
   * Gives elements, whose geometry the bodies know, the laws, frictions and initial gaps of @p joints.
   *
   * Where rigid joints, or almost rigid ones, cross or have corners, their bars repeat each other:
   * how the elements there share the force between the bodies is not unique. Only these elements
   * get a compliance, a ten-thousandth of that of the bodies there, which makes it unique; the
   * report says so.
   */
  template <int dim>
  JointModel
  make_joint_model(const CondensedSystem<dim> &bodies,
                   const std::vector<JointParameters> &joints,
                   const std::map<std::string, double> &constants);

  template <int dim>
  dealii::Point<dim>
  place_of(const ContactElement &element)
  {
    dealii::Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = element.position[d];
    return point;
  }

  /** @throws InputError if a joint has a negative initial gap at one of its elements. */
  template <int dim>
  void
  check_initial_gaps(const std::vector<ContactElement> &elements,
                     const std::vector<JointParameters> &joints,
                     const std::map<std::string, double> &constants);
} // namespace fuga

#endif
