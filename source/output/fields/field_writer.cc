// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/output/fields/field_writer.h>
#include <fuga/output/fields/joint_patches.h>
#include <fuga/output/fields/paraview_script.h>
#include <fuga/output/fields/stress_postprocessor.h>
#include <fuga/output/files/output_files.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace fuga
{
  namespace
  {
    /** Return flags for fast output without the time of day, so that equal runs have equal
     * files. */
    dealii::DataOutBase::VtkFlags
    vtk_flags()
    {
      dealii::DataOutBase::VtkFlags flags;
      flags.compression_level        = dealii::DataOutBase::VtkFlags::best_speed;
      flags.write_higher_order_cells = false;
      flags.print_date_and_time      = false;
      return flags;
    }

    /** Return @p text without the comment of a PVD or PVTU file, which contains the time of day. */
    std::string
    without_comment(const std::string &text)
    {
      const std::size_t begin = text.find("<!--"), end = text.find("-->\n");
      return begin == std::string::npos || end == std::string::npos
               ? text
               : text.substr(0, begin) + text.substr(end + 4);
    }

    using DistributedVector = dealii::LinearAlgebra::distributed::Vector<double>;

    /** Return displacements by Discretization::dof(), all of which every process has, in the
     * numbering of deal.II and distributed among processes as deal.II does; zero where no body is
     * there. */
    template <int dim>
    DistributedVector
    distributed(const Discretization<dim> &space, const dealii::Vector<double> &u)
    {
      const dealii::DoFHandler<dim> &dofs = space.dof_handler();
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
      DistributedVector result(dofs.locally_owned_dofs(), relevant, dofs.get_communicator());
      std::vector<dealii::types::global_dof_index> indices(dofs.get_fe().n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        {
          const unsigned int number = space.cell_number(cell->active_cell_index());
          if (number == Discretization<dim>::no_cell)
            continue;
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (result.in_local_range(indices[i]))
              {
                const auto [component, k] = dofs.get_fe().system_to_component_index(i);
                result(indices[i])        = u[space.dof(space.cell_nodes(number)[k], component)];
              }
        }
      result.update_ghost_values();
      return result;
    }
  } // namespace

  template <int dim>
  FieldWriter<dim>::FieldWriter(std::string output_directory,
                                const CondensedSystem<dim> &condensed_system,
                                const ModelDefinition &model_definition,
                                const std::vector<std::string> &names)
    : directory(std::move(output_directory))
    , system(condensed_system)
    , model(model_definition)
    , body_names(names)
  {
  }

  template <int dim>
  void
  FieldWriter<dim>::add(const std::string &name,
                        Collection &collection,
                        const double t,
                        const std::string &content)
  {
    const std::string file = fmt::format("{}_{:04d}.vtu", name, collection.size());
    write_complete_file(directory + "/" + file, content);
    collection.emplace_back(t, file);
    write_collection(name, collection);
  }

  // The record is written when all pieces are there.
  template <int dim>
  void
  FieldWriter<dim>::add_bodies(const double t, const dealii::DataOut<dim, dim> &output)
  {
    std::ostringstream content;
    output.write_vtu(content);
    if (processes::number() == 1)
      {
        add("bodies", bodies, t, content.str());
        return;
      }
    const std::string stem = fmt::format("bodies_{:04d}", bodies.size());
    std::vector<std::string> pieces;
    for (unsigned int i = 0; i < processes::number(); ++i)
      pieces.push_back(fmt::format("{}.{}.vtu", stem, i));
    write_piece(directory + "/" + pieces[processes::rank()], content.str());
    processes::meet(processes::Place::fields);
    std::ostringstream record;
    output.write_pvtu_record(record, pieces);
    write_complete_file(directory + "/" + stem + ".pvtu", without_comment(record.str()));
    bodies.emplace_back(t, stem + ".pvtu");
    write_collection("bodies", bodies);
  }

  template <int dim>
  void
  FieldWriter<dim>::write_collection(const std::string &name, const Collection &collection) const
  {
    std::ostringstream pvd;
    dealii::DataOutBase::write_pvd_record(pvd, collection);
    write_complete_file(directory + "/" + name + ".pvd", without_comment(pvd.str()));
  }

  template <int dim>
  void
  FieldWriter<dim>::write_script() const
  {
    write_complete_file(directory + "/" + paraview_script_name, paraview_script);
  }

  template <int dim>
  void
  FieldWriter<dim>::restore(const FieldCollections &collections)
  {
    static_cast<FieldCollections &>(*this) = collections;
    if (!bodies.empty())
      write_script();
    for_each_field(collections, [this](const char *name, const Collection &collection) {
      if (!collection.empty())
        write_collection(name, collection);
    });
  }

  // Bodies that were built in different stages are strained by different displacements.
  template <int dim>
  std::vector<typename FieldWriter<dim>::Part>
  FieldWriter<dim>::parts(const dealii::Vector<double> &displacement) const
  {
    const std::vector<bool> &there = system.discretization().bodies_there();
    std::vector<Part> result       = {{there, displacement}};
    for (const StressFreeShape &shape : system.stress_free_shapes())
      {
        Part part{std::vector<bool>(there.size(), false),
                  system.straining(displacement, shape.stage)};
        for (const Material &material : model.materials)
          if (const unsigned int body = index_of(body_names, material.body);
              material.built_at == shape.stage && there[body])
            {
              part.bodies[body]           = true;
              result.front().bodies[body] = false;
            }
        result.push_back(std::move(part));
      }
    const auto is_empty = [](const Part &part) {
      return std::find(part.bodies.begin(), part.bodies.end(), true) == part.bodies.end();
    };
    result.erase(std::remove_if(result.begin(), result.end(), is_empty), result.end());
    return result;
  }

  template <int dim>
  void
  FieldWriter<dim>::write_bodies(const double t,
                                 const dealii::Vector<double> &displacement,
                                 const dealii::Vector<double> &velocity,
                                 const TemperatureField<dim> &temperature)
  {
    if (bodies.empty())
      write_script();
    const Discretization<dim> &space = system.discretization();
    const StressPostprocessor<dim> stresses(model, body_names, temperature);
    const VectorOutput<dim> displacements("displacement"), velocities("velocity");
    dealii::Vector<float> body(space.triangulation().n_active_cells());
    for (const auto &cell : space.triangulation().active_cell_iterators())
      body[cell->active_cell_index()] = static_cast<float>(cell->material_id());
    processes::meet(processes::Place::fields); // deal.II's functions wait for all
    const DistributedVector moved = distributed(space, displacement);
    const DistributedVector rates =
      velocity.size() > 0 ? distributed(space, velocity) : DistributedVector();
    const auto build = [&](dealii::DataOut<dim> &output, const DistributedVector &strained) {
      output.set_flags(vtk_flags());
      output.attach_dof_handler(space.dof_handler());
      output.add_data_vector(moved, displacements);
      if (velocity.size() > 0)
        output.add_data_vector(rates, velocities);
      output.add_data_vector(strained, stresses);
      output.add_data_vector(body, "body", dealii::DataOut<dim>::type_cell_data);
      output.build_patches(space.mapping(), model.polynomial_degree);
    };
    dealii::DataOut<dim> output;
    if (space.is_complete() && system.stress_free_shapes().empty())
      build(output, moved);
    else
      {
        bool is_first = true;
        for (const Part &part : parts(displacement))
          {
            dealii::DataOut<dim> more;
            dealii::DataOut<dim> &selected = is_first ? output : more;
            selected.set_cell_selection([&part](const auto &cell) {
              return cell->is_active() && cell->is_locally_owned() &&
                     part.bodies[cell->material_id()];
            });
            const DistributedVector strained = distributed(space, part.straining);
            build(selected, strained);
            if (!is_first)
              output.merge_patches(more);
            is_first = false;
          }
      }
    add_bodies(t, output);
  }

  template <int dim>
  void
  FieldWriter<dim>::write_joints(const double t,
                                 const std::vector<ContactElement> &elements,
                                 const std::vector<ElementResult> &results,
                                 const Vector &dissipation)
  {
    const auto write = [&](const std::string &name, Collection &collection, const JointView view) {
      if (!processes::is_first())
        return;
      JointPatches<dim> patches(system, elements, results, dissipation, view);
      patches.set_flags(vtk_flags());
      std::ostringstream content;
      patches.write_vtu(content);
      add(name, collection, t, content.str());
    };
    write("joints", joints, JointView::in_place);
    write("joints_exploded", exploded, JointView::exploded);
  }

  template class FieldWriter<2>;
  template class FieldWriter<3>;
} // namespace fuga
