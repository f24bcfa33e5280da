// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_fields_joint_patches_h
#define fuga_output_fields_joint_patches_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/output/results/joint_results.h>

#include <deal.II/base/data_out_base.h>

namespace fuga
{
  /** The ways in which joints are drawn. */
  enum class JointView
  {
    /** At their place, both lips as one. */
    in_place,
    /** Both lips, moved apart along the normal by a share of the joint's length. */
    exploded
  };

  /**
   * The faces of the joints with the results of their contact elements as point data: lines in the
   * plane, quadrilaterals or triangles in space, where the vectors of shear and slip are also given
   * in global axes. A node without element (the tip of a joint, a node held by supports) has zeros
   * and the state 3, bonded.
   */
  template <int dim>
  class JointPatches : public dealii::DataOutInterface<dim - 1, dim>
  {
  public:
    JointPatches(const CondensedSystem<dim> &system,
                 const std::vector<ContactElement> &elements,
                 const std::vector<ElementResult> &results,
                 const Vector &dissipation,
                 const JointView view);

  protected:
    using Patch = dealii::DataOutBase::Patch<dim - 1, dim>;

    const std::vector<Patch> &
    get_patches() const override;

    std::vector<std::string>
    get_dataset_names() const override;

    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;

  private:
    void
    add_face(const JointFace &face, const double offset);

    /**
     * Return the values at a node of a face, in the order of the names. At a hanging node the
     * fields are interpolated; its state, area, dissipation and number are those of the master with
     * the largest weight.
     */
    std::vector<double>
    values_at(const std::vector<std::pair<unsigned int, double>> &shares) const;

    std::vector<double>
    values_of(const unsigned int element) const;

    const CondensedSystem<dim> &system;
    const std::vector<ContactElement> &elements;
    const std::vector<ElementResult> &results;
    const Vector &dissipation;
    std::vector<Patch> patches;
  };
} // namespace fuga

#endif
