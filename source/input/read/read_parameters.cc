// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/input/dynamics/dynamics_readers.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/joints/joint_readers.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/parameter_readers.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/input/stiffness_need.h>
#include <fuga/input/values/parameter_scanner.h>
#include <fuga/input/values/parameter_values.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    read_mesh_file(const ParameterSection &mesh, const std::string &parameter_file)
    {
      const MeshEntries &e   = entries_of<MeshEntries>();
      const std::string name = mesh.text(e.file);
      const std::string path = resolve(parameter_file, name);
      std::error_code ignored;
      if (fs::path(name).extension() != ".msh")
        mesh.fail(e.file, "the name of a mesh file ends in .msh (Gmsh, version 2.2 or 4.1, text).");
      if (!fs::exists(path, ignored))
        mesh.fail(
          e.file,
          fmt::format("the mesh file '{}' does not exist. The name is relative to the folder "
                      "of the parameter file.",
                      path));
      if (fs::is_directory(path, ignored))
        mesh.fail(e.file, "this is a directory. Give the name of a .msh file.");
      return path;
    }


    std::vector<Material>
    read_materials(const ParameterValues &values)
    {
      std::vector<Material> materials;
      for (const ParameterSection &section : values.subsections<BodyEntries>())
        {
          materials.push_back({section.name()});
          section.read(materials.back());
        }
      if (materials.empty())
        throw InputError(
          fmt::format("{}: there are no bodies. Add a section Bodies with one subsection "
                      "per physical group of cells.",
                      values.file()));
      return materials;
    }


    /** Check that no entry refers to the direction across the plane, which has no meaning in
     * space. */
    void
    check_space(const ParameterSection &mesh, const unsigned int dimension)
    {
      const MeshEntries &e = entries_of<MeshEntries>();
      for (const AnyEntry &entry : {AnyEntry(e.assumption), AnyEntry(e.thickness)})
        if (dimension == 3 && mesh.given(entry))
          mesh.fail(entry,
                    "a model in space (Dimension = 3) has no plane and nothing across it. Remove "
                    "this entry.");
    }


    void
    read_mesh_settings(const ParameterSection &mesh, ModelDefinition &model)
    {
      const MeshEntries &e = entries_of<MeshEntries>();
      check_space(mesh, model.dimension);
      mesh.read(model);
      if (model.assumption == PlaneAssumption::axisymmetric && mesh.given(e.thickness))
        mesh.fail(e.thickness,
                  fmt::format("an axisymmetric model ({}) has no thickness: areas and forces are "
                              "those of the full circle. Remove this entry.",
                              mesh.origin(e.assumption)));
    }


    ModelDefinition
    read_model(const ParameterValues &values)
    {
      ModelDefinition model;
      values.section<TopLevel>().read(model);
      values.section<SolverEntries>().read(model);
      model.constants       = values.constants();
      model.constants["pi"] = std::acos(-1.);

      const ParameterSection mesh = values.section<MeshEntries>();
      values.attempt(mesh, [&]() { read_mesh_settings(mesh, model); });
      if (!values.is_broken<BodyEntries>())
        model.materials = read_materials(values);
      model.boundary_conditions = read_boundaries(values, model.dimension);
      model.loads               = read_loads(values, model);
      model.stages              = read_stages(values, model);
      if (model.stages.empty())
        throw InputError(fmt::format("{}: there are no stages, so that nothing would happen. Add a "
                                     "section Stages with one subsection per load stage.",
                                     values.file()));
      model.monitors = read_monitors(values, model.dimension);
      check_loads_and_supports(values, model);
      return model;
    }

  } // namespace


  std::string
  resolve(const std::string &parameter_file, const std::string &path)
  {
    return (fs::path(parameter_file).parent_path() / path).lexically_normal().string();
  }


  Parameters
  read_parameters(const std::string &file, const std::vector<std::string> &overrides)
  {
    ParameterScan scan = scan_parameter_file(file);
    apply_overrides(scan, overrides);
    const SweepPlan plan(std::move(scan));
    if (plan.n_variants() > 0)
      return read_sweep(plan);
    InputErrors errors(file);
    return read_scan(plan.file(), errors);
  }


  Parameters
  read_scan(const ParameterScan &scan, InputErrors &errors)
  {
    const std::string &file = scan.file;
    const ParameterValues values(scan, errors);
    // Everything else depends on the dimension, and expressions depend on the constants.
    if (values.is_broken<TopLevel>() || values.is_broken<ConstantEntries>() ||
        values.is_broken<SolverEntries>())
      errors.throw_if_any();

    Parameters parameters;
    parameters.of_sweep       = values.is_variant();
    parameters.parameter_file = file;
    parameters.title          = values.section<TopLevel>().value(entries_of<TopLevel>().title);
    if (!errors.attempt([&]() { parameters.model = read_model(values); }))
      errors.throw_if_any();
    parameters.joints = read_joints(values, parameters.model);
    if (values.is_broken<SolverEntries>() || values.is_broken<OutputEntries>() ||
        values.is_broken<SweepEntries>() || values.is_broken<SafetyEntries>() ||
        values.is_broken<AccuracyEntries>() || values.is_broken<DynamicsEntries>() ||
        values.is_broken<EarthquakeEntries>())
      errors.throw_if_any();
    values.section<SolverEntries>().read(parameters.solver);
    errors.attempt([&]() { read_output(values, parameters); });
    const ParameterSection mesh = values.section<MeshEntries>();
    values.attempt(mesh, [&]() { parameters.mesh_file = read_mesh_file(mesh, file); });
    errors.throw_if_any(); // the following needs everything above

    errors.attempt([&]() {
      read_construction(values, parameters.model);
      check_sweep_of_construction(values, parameters);
    });
    errors.attempt([&]() { read_safety(values, parameters); });
    errors.attempt([&]() { read_dynamics(values, parameters); });
    errors.attempt([&]() { read_accuracy(values, parameters); });
    errors.throw_if_any();
    parameters.echo                     = values.echo();
    parameters.model.may_be_matrix_free = what_needs_stiffness(parameters).empty();
    return parameters;
  }
} // namespace fuga
