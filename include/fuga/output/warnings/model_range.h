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

  /** Of one joint. */
  struct JointExcess
  {
    ModelExcess normal_table, shear_table, slip, turn;
  };

  /** Watches whether a run leaves what its model is made for: the data of tabular laws, and
   * displacements that are small beside the joints. */
  class ModelRange
  {
  public:
    /** By joint; outlives phases of construction and restarts. */
    using Record = std::vector<JointExcess>;

    /** @p record, empty or of an earlier phase, must live as long as this object. */
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
      /** At the last point of the table. */
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
    /** By joint: the diagonal of the box about its elements [m]. */
    const std::vector<double> lengths;
    Record &record;

    /** By joint: smallest and largest opening, and where the latter is. */
    struct Openings
    {
      double least, most;
      const ContactElement *widest;
    };
    std::vector<Openings> openings;
  };

  /** One sentence per excess. */
  template <int dim>
  std::vector<std::string>
  range_warnings(const ModelRange::Record &record,
                 const std::vector<std::string> &joint_names,
                 const Units &units);
} // namespace fuga

#endif
