// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/io/parameter_readers.h>
#include <fuga/io/parameter_scanner.h>
#include <fuga/io/parameter_values.h>
#include <fuga/io/parameters.h>
#include <fuga/io/stiffness_need.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace fuga
{
  namespace
  {
    namespace fs = std::filesystem;

    /** A path of the file, which is relative to the folder of the file. */
    std::string
    resolve(const std::string &parameter_file, const std::string &path)
    {
      return (fs::path(parameter_file).parent_path() / path).lexically_normal().string();
    }


    std::string
    read_mesh_file(const ParameterSection &mesh, const std::string &parameter_file)
    {
      const std::string name = mesh.text("File");
      const std::string path = resolve(parameter_file, name);
      std::error_code ignored;
      if (fs::path(name).extension() != ".msh")
        mesh.fail("File", "the name of a mesh file ends in .msh (Gmsh, version 2.2 or 4.1, text).");
      if (!fs::exists(path, ignored))
        mesh.fail(
          "File",
          fmt::format("the mesh file '{}' does not exist. The name is relative to the folder "
                      "of the parameter file.",
                      path));
      if (fs::is_directory(path, ignored))
        mesh.fail("File", "this is a directory. Give the name of a .msh file.");
      return path;
    }


    std::vector<Material>
    read_materials(const ParameterValues &values)
    {
      std::vector<Material> materials;
      for (const ParameterSection &section : values.subsections("Bodies"))
        materials.push_back({section.name(),
                             section.number("Young modulus"),
                             section.number("Poisson ratio"),
                             section.number("Weight density"),
                             section.number("Thermal expansion")});
      if (materials.empty())
        throw InputError(
          fmt::format("{}: there are no bodies. Add a section Bodies with one subsection "
                      "per physical group of cells.",
                      values.file()));
      return materials;
    }


    /** What speaks of the direction across the plane has no meaning in space. */
    void
    check_space(const ParameterSection &mesh, const unsigned int dimension)
    {
      for (const char *const entry : {"Assumption", "Thickness"})
        if (dimension == 3 && mesh.given(entry))
          mesh.fail(entry,
                    "a model in space (Dimension = 3) has no plane and nothing across it. Remove "
                    "this entry.");
    }


    BodySolver
    read_body_solver(const ParameterSection &section)
    {
      for (const BodySolver solver : {BodySolver::direct,
                                      BodySolver::direct_on_disk,
                                      BodySolver::iterative,
                                      BodySolver::matrix_free})
        if (section.text("Bodies") == name_of(solver))
          return solver;
      return BodySolver::automatic;
    }


    void
    read_mesh_settings(const ParameterSection &mesh, ModelDefinition &model)
    {
      check_space(mesh, model.dimension);
      model.polynomial_degree      = mesh.integer("Polynomial degree");
      model.refinements            = mesh.integer("Refinements");
      const std::string assumption = mesh.text("Assumption");
      model.assumption             = assumption == "plane stress"   ? PlaneAssumption::plane_stress
                                     : assumption == "axisymmetric" ? PlaneAssumption::axisymmetric
                                                                    : PlaneAssumption::plane_strain;
      if (model.assumption == PlaneAssumption::axisymmetric && mesh.given("Thickness"))
        mesh.fail("Thickness",
                  fmt::format("an axisymmetric model ({}) has no thickness: areas and forces are "
                              "those of the full circle. Remove this entry.",
                              mesh.origin("Assumption")));
      model.thickness = mesh.number("Thickness");
    }


    ModelDefinition
    read_model(const ParameterValues &values)
    {
      ModelDefinition model;
      model.dimension       = values.section("").integer("Dimension");
      model.load_knots      = values.section("Solver").integer("Load knots");
      model.body_solver     = read_body_solver(values.section("Solver"));
      model.constants       = values.constants();
      model.constants["pi"] = std::acos(-1.);

      const ParameterSection mesh = values.section("Mesh");
      values.attempt(mesh, [&]() { read_mesh_settings(mesh, model); });
      if (!values.is_broken("Bodies"))
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


    SolverSettings
    read_solver(const ParameterSection &section)
    {
      SolverSettings solver;
      solver.follow_events       = section.text("Follow") == "events";
      const std::string branch   = section.text("Non-unique");
      solver.non_unique          = branch == "stop"    ? NonUniqueChoice::stop
                                   : branch == "first" ? NonUniqueChoice::first
                                                       : NonUniqueChoice::largest_dissipation;
      solver.beyond_limit        = section.text("Beyond limit load") == "arc length";
      solver.beyond_jump         = section.number("Largest jump beyond limit");
      solver.iteration           = section.text("Iteration") == "newton" ? IterationKind::newton
                                                                         : IterationKind::constant_stiffness;
      solver.iteration_tolerance = section.number("Iteration tolerance");
      solver.maximum_iterations  = section.integer("Maximum iterations");
      solver.certificate_bound   = section.number("Certificate bound");
      return solver;
    }


    OutputSettings
    read_output(const ParameterValues &values, const std::string &parameter_file)
    {
      const ParameterSection section = values.section("Output");
      const std::string directory    = values.section("").text("Output directory");
      const std::string fields       = section.text("Fields");
      const std::string checkpoint   = section.text("Checkpoint");
      const std::string log          = section.text("Log");
      OutputSettings output;
      output.directory  = directory.empty()
                            ? (fs::path("results") / fs::path(parameter_file).stem()).string()
                            : resolve(parameter_file, directory);
      output.fields     = fields == "levels" ? FieldOutput::levels
                          : fields == "end"  ? FieldOutput::end
                                             : FieldOutput::never;
      output.checkpoint = checkpoint == "levels"        ? CheckpointOutput::levels
                          : checkpoint == "events"      ? CheckpointOutput::events
                          : checkpoint == "every event" ? CheckpointOutput::every_event
                                                        : CheckpointOutput::never;
      output.monitors =
        section.text("Monitors") == "events" ? MonitorOutput::events : MonitorOutput::levels;
      output.log    = log == "events"   ? LogDetail::events
                      : log == "levels" ? LogDetail::levels
                                        : LogDetail::quiet;
      output.report = section.text("Report") == "true";
      output.units  = {section.text("Force unit"),
                       section.text("Length unit"),
                       section.given("Force unit") || section.given("Length unit")};
      return output;
    }
  } // namespace


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
    // All else depends on the dimension, and expressions on the constants.
    if (values.is_broken("") || values.is_broken("Constants") || values.is_broken("Solver"))
      errors.throw_if_any();

    Parameters parameters;
    parameters.of_sweep       = values.is_variant();
    parameters.parameter_file = file;
    parameters.title          = values.section("").text("Title");
    if (!errors.attempt([&]() { parameters.model = read_model(values); }))
      errors.throw_if_any();
    parameters.joints = read_joints(values, parameters.model);
    for (const char *const name : {"Solver", "Output", "Sweep", "Safety", "Target accuracy"})
      if (values.is_broken(name))
        errors.throw_if_any();
    parameters.solver           = read_solver(values.section("Solver"));
    parameters.output           = read_output(values, file);
    const ParameterSection mesh = values.section("Mesh");
    values.attempt(mesh, [&]() { parameters.mesh_file = read_mesh_file(mesh, file); });
    errors.throw_if_any(); // what follows needs all that is above

    errors.attempt([&]() {
      read_construction(values, parameters.model);
      check_sweep_of_construction(values, parameters);
    });
    errors.attempt([&]() { read_safety(values, parameters); });
    errors.attempt([&]() { read_accuracy(values, parameters); });
    errors.throw_if_any();
    parameters.echo                     = values.echo();
    parameters.model.may_be_matrix_free = what_needs_stiffness(parameters).empty();
    return parameters;
  }
} // namespace fuga
