// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_mechanism_text_h
#define fuga_output_results_mechanism_text_h

#include <fuga/contact/contact_element.h>
#include <fuga/output/results/joint_resultant.h>

#include <optional>

namespace fuga
{
  /** The relative motion of the faces of one joint in a mechanism. */
  struct JointMotion
  {
    bool slides = false;
    bool opens  = false;
    /** Whether lips that are apart approach each other everywhere. */
    bool closes = false;
    /** Whether they turn against each other. */
    bool turns = false;
    /** The centre of rotation, in the plane, if they turn as two rigid bodies. */
    std::optional<std::array<double, 2>> centre;
  };

  /**
   * Return the motion of every joint. @p jumps are those of the bars, the largest of which is 1;
   * @p frames has one entry per element. A motion below a thousandth of the largest of the whole
   * model counts as none; so does opening or closing below a thousandth of the sliding in the same
   * joint, and vice versa.
   */
  std::vector<JointMotion>
  joint_motions(const std::size_t n_joints,
                const std::vector<ContactElement> &elements,
                const std::vector<ElementFrame> &frames,
                const Vector &jumps,
                const bool in_space);

  /** Return a sentence such as "slides on 'seam'; 'heel crack' opens"; empty if nothing moves. */
  std::string
  mechanism_text(const std::vector<JointMotion> &motions,
                 const std::vector<std::string> &joint_names);
} // namespace fuga

#endif
