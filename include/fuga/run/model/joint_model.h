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
  /** Contact elements together with the laws of their joints, to which they point. */
  struct JointModel
  {
    /**
     * Normal and shear law of joint j: entries 2j and 2j + 1; followed by the laws of single
     * elements.
     */
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    /**
     * Couplings of joints whose shear stiffness grows with closure or pressure; they use the laws
     * above.
     */
    std::vector<std::unique_ptr<ShearCoupling>> couplings;
    std::vector<ContactElement> elements;
    /** Lines for the log. */
    std::vector<std::string> report;
  };

  /**
   * Create the elements, whose geometry is known to the bodies, with the laws, frictions and
   * initial gaps of @p joints.
   *
   * Where rigid or almost rigid joints cross or have corners, their bars are redundant: the way in
   * which the elements there share the force between the bodies is not unique. Only these elements
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

  /**
   * Check the initial gaps. @throws InputError if a joint has a negative gap at one of its
   * elements.
   */
  template <int dim>
  void
  check_initial_gaps(const std::vector<ContactElement> &elements,
                     const std::vector<JointParameters> &joints,
                     const std::map<std::string, double> &constants);
} // namespace fuga

#endif
