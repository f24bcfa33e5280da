// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_joint_model_h
#define fuga_joint_model_h

#include <fuga/contact/contact_element.h>
#include <fuga/io/parameters.h>

#include <memory>

namespace fuga
{
  /** Contact elements with the laws of their joints, which they point to. */
  struct JointModel
  {
    /** Normal and shear law of every joint: entries 2j and 2j + 1. */
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    std::vector<ContactElement> elements;
  };

  /**
   * Gives elements, whose geometry the bodies know, the laws, frictions and initial gaps of @p joints.
   * @throws InputError for a negative initial gap.
   */
  template <int dim>
  JointModel
  make_joint_model(const std::vector<ContactElement> &geometry,
                   const std::vector<JointParameters> &joints,
                   const std::map<std::string, double> &constants);
} // namespace fuga

#endif
