// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_model_range_h
#define fuga_output_warnings_model_range_h

#include <fuga/base/fields.h>
#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>
#include <fuga/input/units.h>

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /** The farthest that a joint has gone beyond what its model is made for. */
  struct ModelExcess
  {
    /** Stress beyond a table, slip, difference of openings; 0: the joint is within its model. */
    double largest = 0.;
    /** End of the table, or length of the joint [m]. */
    double limit = 0.;
    double t     = 0.;
    /** Which element. */
    unsigned int element           = 0;
    std::array<double, 3> position = {{0., 0., 0.}};
  };

  template <typename Excess, typename Visitor, only_for<Excess, ModelExcess> = 0>
  void
  for_each_field(Excess &excess, Visitor &&visit)
  {
    auto &[largest, limit, t, element, position] = excess;
    visit("largest", largest);
    visit("limit", limit);
    visit("t", t);
    visit("element", element);
    visit("position", position);
  }

  /** Watches whether a run leaves what its model is made for: the data of tabular laws, and
   * displacements that are small beside the joints. */
  class ModelRange
  {
  public:
    /** By joint and kind of excess; outlives phases of construction and restarts. */
    using Record = std::vector<ModelExcess>;

    /** @p record, empty or of an earlier phase, must live as long as this object. */
    ModelRange(const std::vector<ContactElement> &elements,
               const std::size_t n_joints,
               Record &record);

    void
    watch(const JointState &state);

  private:
    void
    watch_table(const ContactElement &element, const JointState &state, const bool normal);

    const std::vector<ContactElement> &elements;
    /** By joint: the diagonal of the box about its elements [m]. */
    std::vector<double> lengths;
    Record &record;
  };

  /** One sentence per excess. */
  template <int dim>
  std::vector<std::string>
  range_warnings(const ModelRange::Record &record,
                 const std::vector<std::string> &joint_names,
                 const Units &units);
} // namespace fuga

#endif
