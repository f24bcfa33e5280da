// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_model_range_h
#define fuga_output_warnings_model_range_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>
#include <fuga/input/units.h>

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /** The largest excess of a joint beyond the range of its model. */
  struct ModelExcess
  {
    /**
     * Stress beyond a table, slip, or difference of openings; 0 if the joint is within its model.
     */
    double largest = 0.;
    /** End of the table, or length of the joint [m]. */
    double limit = 0.;
    double t     = 0.;
    /** The element, and its position. */
    unsigned int element           = 0;
    std::array<double, 3> position = {{0., 0., 0.}};
  };

  /** The excesses of one joint. */
  struct JointExcess
  {
    ModelExcess normal_table, shear_table, slip, turn;
  };

  /**
   * Watches whether a run leaves the range of its model: the data of tabular laws, and
   * displacements that are small compared with the joints.
   */
  class ModelRange
  {
  public:
    /** The excesses by joint; they outlive phases of construction and restarts. */
    using Record = std::vector<JointExcess>;

    /** @p record is empty or that of an earlier phase, and must live as long as this object. */
    ModelRange(const std::vector<ContactElement> &elements,
               const std::size_t n_joints,
               Record &record);

    void
    watch(const JointState &state);

  private:
    /** A bar with a law that is a table. */
    struct TabulatedBar
    {
      const ContactElement *element;
      bool is_normal;
      /** Stress at the last point of the table. */
      double stress;
    };

    void
    watch_tables(const JointState &state);
    void
    watch_slips(const JointState &state);
    void
    watch_turns(const JointState &state);

    const std::vector<ContactElement> &elements;
    std::vector<TabulatedBar> tabulated_bars;
    /** Diagonal of the box around the elements of each joint [m]. */
    const std::vector<double> lengths;
    Record &record;

    /** Smallest and largest opening of a joint, and the element with the latter. */
    struct Openings
    {
      double least, most;
      const ContactElement *widest;
    };
    std::vector<Openings> openings;
  };

  /** Return one sentence per excess. */
  template <int dim>
  std::vector<std::string>
  range_warnings(const ModelRange::Record &record,
                 const std::vector<std::string> &joint_names,
                 const Units &units);
} // namespace fuga

#endif
