// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_field_writer_h
#define fuga_io_field_writer_h

#include <fuga/bodies/condensed_system.h>
#include <fuga/io/joint_results.h>

namespace fuga
{
  /**
   * Writes the fields of one load level as VTU files and keeps the PVD collections that ParaView
   * opens:
   *  - bodies.pvd: displacement, stress tensor, principal stresses, von Mises stress, body;
   *  - joints.pvd: one line cell per joint face with gap, closure, slip, ... at its contact
   * elements;
   *  - joints_exploded.pvd: the same on both lips, moved apart along the normal so that they can be
   * seen. Every file appears complete. Values are rounded to single precision; for numbers see the
   * CSV files.
   */
  template <int dim>
  class FieldWriter
  {
  public:
    FieldWriter(std::string directory,
                const CondensedSystem<dim> &system,
                const ModelDefinition &model,
                const std::vector<std::string> &body_names);

    void
    write_bodies(const double t, const dealii::Vector<double> &displacement);

    void
    write_joints(const double t,
                 const std::vector<ContactElement> &elements,
                 const std::vector<ElementResult> &results,
                 const Vector &dissipation);

  private:
    using Collection = std::vector<std::pair<double, std::string>>;

    void
    write_collection(const std::string &name,
                     Collection &collection,
                     const double t,
                     const std::string &content);

    const std::string directory;
    const CondensedSystem<dim> &system;
    const ModelDefinition &model;
    const std::vector<std::string> body_names;
    Collection bodies, joints, exploded;
  };
} // namespace fuga

#endif
