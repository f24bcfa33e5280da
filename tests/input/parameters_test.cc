// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_test_files.h"

#include <fuga/base/errors.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fuga
{
  using testing_files::example_prm;
  using testing_files::replaced;
  using testing_files::write_file;

  namespace
  {
    Parameters
    read_text(const std::string &name,
              const std::string &text,
              const std::vector<std::string> &overrides = {})
    {
      return read_parameters(write_file(name, text), overrides);
    }
  } // namespace

  TEST(Parameters, ReadsEverySection)
  {
    const Parameters p = read_text("example.prm", example_prm());
    EXPECT_EQ(p.title, "An example");
    EXPECT_EQ(std::filesystem::path(p.mesh_file).filename(), "example.msh");
    EXPECT_TRUE(std::filesystem::exists(p.mesh_file));
    EXPECT_EQ(p.output.directory, "results/example");
    EXPECT_EQ(p.output.fields, FieldOutput::end);
    EXPECT_EQ(p.output.log, LogDetail::events);
    EXPECT_EQ(p.solver.iteration, IterationKind::newton);
    EXPECT_EQ(p.solver.maximum_iterations, 200u);
    EXPECT_EQ(p.solver.iteration_tolerance, 1e-12);
    EXPECT_EQ(p.solver.certificate_bound, 1e-9);

    const ModelDefinition &model = p.model;
    EXPECT_EQ(model.dimension, 2u);
    EXPECT_EQ(model.polynomial_degree, 2u);
    EXPECT_EQ(model.refinements, 0u);
    EXPECT_EQ(model.assumption, PlaneAssumption::plane_stress);
    EXPECT_EQ(model.thickness, 0.5);
    EXPECT_EQ(model.load_knots, 20u);
    EXPECT_EQ(model.constants.at("q"), 0.0144);
    EXPECT_EQ(model.constants.at("pi"), std::acos(-1.));
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.materials[0].body, "dam");
    EXPECT_EQ(model.materials[0].young_modulus, 3060.);
    EXPECT_EQ(model.materials[1].weight_density, 0.);
  }

  TEST(Parameters, ReadsSupportsLoadsAndStages)
  {
    const ModelDefinition model = read_text("loads.prm", example_prm()).model;
    ASSERT_EQ(model.boundary_conditions.size(), 3u);
    EXPECT_EQ(model.boundary_conditions[0].fixed, (std::array<bool, 3>{{true, true, false}}));
    EXPECT_EQ(model.boundary_conditions[1].fixed, (std::array<bool, 3>{{true, false, false}}));
    EXPECT_TRUE(model.boundary_conditions[2].named_free);
    EXPECT_NE(model.boundary_conditions[2].origin.find("loads.prm:51"), std::string::npos);

    ASSERT_EQ(model.loads.size(), 4u);
    EXPECT_EQ(model.loads[0].expressions, (std::vector<std::string>{"0", "-1"}));
    EXPECT_EQ(model.loads[1].targets, (std::vector<std::string>{"upstream"}));
    EXPECT_EQ(model.loads[2].kind, LoadKind::point_force);
    EXPECT_TRUE(model.loads[2].has_coordinates);
    EXPECT_EQ(model.loads[2].coordinates[1], 12.);
    EXPECT_EQ(model.loads[3].expressions, (std::vector<std::string>{"", "-0.001"}));

    ASSERT_EQ(model.stages.size(), 2u);
    EXPECT_EQ(model.stages[0].name, "weight");
    EXPECT_EQ(model.stages[1].levels, 10u);
    ASSERT_EQ(model.stages[1].histories.size(), 3u);
    EXPECT_EQ(model.stages[1].histories[1].load, 2u);
    EXPECT_EQ(model.stages[1].histories[1].expression, "sin(pi*t/2)");
  }

  TEST(Parameters, ReadsJoints)
  {
    const std::vector<JointParameters> joints = read_text("joints.prm", example_prm()).joints;
    ASSERT_EQ(joints.size(), 2u);
    const JointParameters &base = joints[0];
    EXPECT_EQ(base.definition.line, "base");
    EXPECT_EQ(base.definition.plus_body, "dam");
    EXPECT_EQ(base.definition.minus_body, "rock");
    EXPECT_EQ(base.normal_law, LayerLaw::cubic_root);
    EXPECT_EQ(base.normal_compliance, 1.25e-4);
    EXPECT_EQ(base.normal_layer_modulus(), 16.);
    EXPECT_EQ(base.shear_law, LayerLaw::linear);
    EXPECT_EQ(base.shear_compliance, 1.25e-4);
    EXPECT_EQ(base.friction.coefficient, 0.2);
    EXPECT_EQ(base.initial_gap, "0.001*x");
    EXPECT_EQ(base.definition.corner_angle, 30.);

    const JointParameters &wall = joints[1];
    EXPECT_TRUE(wall.definition.against_rigid);
    EXPECT_EQ(wall.definition.plus_lip, "wall");
    EXPECT_EQ(wall.definition.minus_lip, "");
    EXPECT_EQ(wall.normal_law, LayerLaw::rigid); // linear, but compliance 0
    EXPECT_EQ(wall.shear_law, LayerLaw::rigid);
    EXPECT_NEAR(wall.friction.coefficient, 1., 1e-15);
    EXPECT_EQ(wall.friction.cohesion, 0.1);
  }

  TEST(Parameters, FrictionlessJointNeedsNoShearLayer)
  {
    const std::string text = replaced(
      example_prm(),
      {{"    set Shear stiffness = 8000\n", ""}, {"    set Friction coefficient = 0.2\n", ""}});
    const Parameters p = read_text("frictionless.prm", text);
    EXPECT_TRUE(p.joints[0].friction.is_frictionless());
    EXPECT_EQ(p.joints[0].shear_compliance, 0.);
    EXPECT_EQ(p.joints[0].shear_law, LayerLaw::rigid);
  }

  TEST(Parameters, JsonAndPrmSayTheSame)
  {
    const Parameters from_prm  = read_text("same.prm", example_prm());
    const Parameters from_json = read_text("same.json", echo_json(from_prm));
    EXPECT_EQ(from_prm.echo, from_json.echo);
    EXPECT_EQ(from_prm.model.stages[1].histories[0].expression,
              from_json.model.stages[1].histories[0].expression);
    EXPECT_EQ(from_prm.output.directory, from_json.output.directory);
    EXPECT_NE(from_json.joints[0].origin.find("same.json:"), std::string::npos);
  }

  TEST(Parameters, JsonTakesNumbers)
  {
    const std::string text =
      replaced(echo_json(read_text("numbers.prm", example_prm())),
               {{"\"0.0144\"", "1.44e-2"}, {"\"Levels\": \"10\"", "\"Levels\": 10"}});
    const Parameters p = read_text("numbers.json", text);
    EXPECT_EQ(p.model.constants.at("q"), 0.0144);
    EXPECT_EQ(p.model.stages[1].levels, 10u);
  }

  TEST(Parameters, OrderOfStagesIsThatOfTheFile)
  {
    const std::string text =
      replaced(example_prm(),
               {{"subsection weight\n    set Loads", "subsection zz\n    set Loads"},
                {"subsection push\n    set Loads", "subsection aa\n    set Loads"}});
    for (const Parameters &p : {read_text("order.prm", text),
                                read_text("order.json", echo_json(read_text("order.prm", text)))})
      {
        ASSERT_EQ(p.model.stages.size(), 2u);
        EXPECT_EQ(p.model.stages[0].name, "zz");
        EXPECT_EQ(p.model.stages[1].name, "aa");
      }
  }

  TEST(Parameters, OverridesReplaceAddAndRemove)
  {
    const Parameters p = read_text("overrides.prm",
                                   example_prm(),
                                   {"Joints/base/Friction coefficient=0.3",
                                    "Constants/q = 1",
                                    "Constants/extra=-2",
                                    "Mesh/Refinements=3",
                                    "Title=A = B",
                                    "Joints/base/Shear stiffness=",
                                    "Joints/base/Shear compliance=0"});
    EXPECT_EQ(p.joints[0].friction.coefficient, 0.3);
    EXPECT_EQ(p.joints[0].shear_law, LayerLaw::rigid);
    EXPECT_EQ(p.model.constants.at("q"), 1.);
    EXPECT_EQ(p.model.constants.at("extra"), -2.);
    EXPECT_EQ(p.model.refinements, 3u);
    EXPECT_EQ(p.title, "A = B");
  }

  TEST(Parameters, EchoHasDefaultsAndOverrides)
  {
    const Parameters p = read_text("echo.prm", example_prm(), {"Solver/Load knots=7"});
    const auto has     = [&](const std::string &path, const std::string &value) {
      return std::count(p.echo.begin(), p.echo.end(), std::make_pair(path, value)) == 1;
    };
    EXPECT_TRUE(has("Solver/Load knots", "7"));
    EXPECT_TRUE(has("Solver/Certificate bound", "1e-9"));
    EXPECT_TRUE(has("Joints/wall/Initial gap", "0"));
    EXPECT_TRUE(has("Dimension", "2"));
  }

  TEST(Parameters, SyntaxOfPrm)
  {
    const std::string text =
      "\xEF\xBB\xBF" + // a mark that some editors write
      replaced(example_prm(),
               {{"set Title = An example", "SET  Title\t=  An \\ # half\r\n   example\r"},
                {"subsection Mesh", "  subsection   Mesh # comment"}});
    EXPECT_EQ(read_text("syntax.prm", text).title, "An example");
  }

  TEST(Parameters, OutputDirectoryIsRelativeToTheFile)
  {
    const Parameters p = read_text("directory.prm", example_prm(), {"Output directory=out/a"});
    EXPECT_EQ(std::filesystem::path(p.output.directory),
              std::filesystem::path(p.parameter_file).parent_path() / "out/a");
  }

  TEST(Parameters, ExpressionsMayBeUndefinedElsewhere)
  {
    EXPECT_NO_THROW(
      read_text("sqrt.prm", example_prm(), {"Loads/push/Value=q*sqrt(x - 10)/max(x, y)"}));
  }

  TEST(Parameters, DefaultTextParsesBack)
  {
    const std::string text = default_parameter_text();
    for (const char *const word :
         {"Friction angle", "cubic root", "Certificate bound", "Weight density"})
      EXPECT_NE(text.find(word), std::string::npos) << word;
    write_file("mesh.msh", "");
    const Parameters p = read_text("default.prm", text);
    EXPECT_EQ(p.model.materials.size(), 2u);
    EXPECT_EQ(p.joints.size(), 1u);
    EXPECT_EQ(p.model.stages.size(), 2u);
    EXPECT_EQ(read_text("default.json", echo_json(p)).echo, p.echo);
  }

  TEST(Parameters, ShippedFilesAreValid)
  {
    namespace fs = std::filesystem;
    // The meshes are made elsewhere; here an empty file stands for each.
    for (const char *const mesh : {"s0", "raous_64", "scene_g_33"})
      write_file("shipped/meshes/" + std::string(mesh) + ".msh", "");
    unsigned int n = 0;
    for (const auto &entry : fs::directory_iterator(fs::path(FUGA_SOURCE_DIR) / "parameters"))
      if (entry.path().extension() == ".prm")
        {
          const std::string copy =
            write_file("shipped/parameters/" + entry.path().filename().string(), "");
          fs::copy_file(entry.path(), copy, fs::copy_options::overwrite_existing);
          try
            {
              EXPECT_FALSE(read_parameters(copy).joints.empty());
              ++n;
            }
          catch (const InputError &error)
            {
              const bool has_other_mesh =
                std::string(error.what()).find("does not exist") != std::string::npos;
              EXPECT_TRUE(has_other_mesh) << error.what();
            }
        }
    EXPECT_GE(n, 9u);
  }
} // namespace fuga
