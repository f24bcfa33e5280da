// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_uplift_assembly_h
#define fuga_bodies_uplift_assembly_h

#include <fuga/bodies/contact_bars.h>
#include <fuga/bodies/load_assembly.h>

namespace fuga
{
  /**
   * Turns water in joints into forces between the lips of contact elements: ∫ N u dA along the
   * faces of the joint, exact also where the line of the water or of its distribution has a corner
   * within a face. What an element gets in addition by opening is not negative. In space the way
   * of the water runs along x, between ends that must be horizontal.
   */
  template <int dim>
  class UpliftAssembly
  {
  public:
    UpliftAssembly(const Discretization<dim> &discretization,
                   const JointGeometry<dim> &geometry,
                   const ContactBars<dim> &bars,
                   const JointedMesh &mesh);

    /** The pattern for one level of the reservoir.
     * @throws InputError for a joint without two ends in the direction given, a drain outside it.
     */
    LoadPattern
    assemble(const LoadDefinition &load, const double level) const;

    /** The levels at which the forces change otherwise than smoothly, increasing: see
     * fuga::levels_of_kinks(). */
    std::vector<double>
    levels_of_kinks(const LoadDefinition &load) const;

  private:
    /** The ends of a joint and the water between them. */
    struct Water
    {
      dealii::Point<dim> upstream, downstream;
      std::vector<std::array<double, 2>> profile;
    };

    Water
    water_of(const LoadDefinition &load, const unsigned int joint) const;

    void
    add_face(const typename JointGeometry<dim>::Face &face,
             const LoadDefinition &load,
             const Water &water,
             const double level,
             Vector &closed,
             Vector &full) const;

    /** @throws InputError if the nodes of the joint at the x of @p end have different heights. */
    void
    require_level_end(const LoadDefinition &load,
                      const unsigned int joint,
                      const dealii::Point<dim> &end) const;

    const Discretization<dim> &discretization;
    const JointGeometry<dim> &geometry;
    const ContactBars<dim> &bars;
    const JointedMesh &mesh;
  };

  /** One part of all patterns as columns of a matrix; an empty matrix if no pattern has it. */
  DenseMatrix
  columns_of(const std::vector<LoadPattern> &patterns, const Vector LoadPattern::*part);
} // namespace fuga

#endif
