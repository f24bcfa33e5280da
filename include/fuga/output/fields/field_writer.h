// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_fields_field_writer_h
#define fuga_output_fields_field_writer_h

#include <fuga/base/fields.h>
#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/output/results/joint_results.h>

#include <deal.II/lac/vector.h>

namespace dealii
{
  template <int dim, int spacedim>
  class DataOut;
}

namespace fuga
{
  /** The files of a run and their load times, by collection. */
  struct FieldCollections
  {
    using Collection = std::vector<std::pair<double, std::string>>;

    Collection bodies, joints, exploded;
  };

  template <typename Collections, typename Visitor, only_for<Collections, FieldCollections> = 0>
  void
  for_each_field(Collections &collections, Visitor &&visit)
  {
    auto &[bodies, joints, exploded] = collections;
    visit("bodies", bodies);
    visit("joints", joints);
    visit("joints_exploded", exploded);
  }

  /**
   * Writes the fields of one load level as VTU files and keeps the PVD collections that ParaView
   * opens:
   * - bodies.pvd: displacement, velocity if one is given, stress tensor, principal stresses, von
   *   Mises stress and body of the bodies that exist;
   * - joints.pvd: one line cell per joint face with gap, closure, slip, ... at its contact
   *   elements;
   * - joints_exploded.pvd: the same on both lips, moved apart along the normal so that they can be
   *   seen;
   * - view_in_paraview.py, which shows all of them.
   *
   * Every file appears complete. Values are rounded to single precision; for all digits see the CSV
   * files.
   *
   * If there are several processes, each one writes the bodies of its own cells, bodies_0000.1.vtu,
   * and the first one writes the record bodies_0000.pvtu that joins them.
   */
  template <int dim>
  class FieldWriter : private FieldCollections
  {
  public:
    FieldWriter(std::string directory,
                const CondensedSystem<dim> &system,
                const ModelDefinition &model,
                const std::vector<std::string> &body_names);

    /** @p velocity is empty unless the bodies are in motion. */
    void
    write_bodies(const double t,
                 const dealii::Vector<double> &displacement,
                 const dealii::Vector<double> &velocity,
                 const TemperatureField<dim> &temperature);

    void
    write_joints(const double t,
                 const std::vector<ContactElement> &elements,
                 const std::vector<ElementResult> &results,
                 const Vector &dissipation);

    /** Return whether the last files written are those of this time. */
    bool
    has_written(const double t) const
    {
      return !bodies.empty() && bodies.back().first == t;
    }

    const FieldCollections &
    memory() const
    {
      return *this;
    }

    /**
     * Continue with these collections, whose files exist; the collections themselves are written
     * again.
     */
    void
    restore(const FieldCollections &collections);

  private:
    /** Bodies by number, and the displacement that strains them. */
    struct Part
    {
      std::vector<bool> bodies;
      dealii::Vector<double> straining;
    };

    std::vector<Part>
    parts(const dealii::Vector<double> &displacement) const;

    void
    add(const std::string &name,
        Collection &collection,
        const double t,
        const std::string &content);
    void
    add_bodies(const double t, const dealii::DataOut<dim, dim> &output);
    void
    write_script() const;
    void
    write_collection(const std::string &name, const Collection &collection) const;

    const std::string directory;
    const CondensedSystem<dim> &system;
    const ModelDefinition &model;
    const std::vector<std::string> body_names;
  };
} // namespace fuga

#endif
