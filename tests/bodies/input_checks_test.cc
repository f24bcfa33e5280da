// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <fuga/base/errors.h>
#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::test;

// Messages must name the thing, the place and the remedy.

TEST(InputChecks, free_motions_are_named)
{
  BlockMesh mesh = two_blocks();
  mesh.mesh.joints.clear();
  ModelDefinition model = two_block_model();
  hold(model, "J+", "y");
  hold(model, "J-", "");
  expect_message(message_of(mesh.mesh, model), {"Body 'upper'", "free to move in x.", "Hold more"});
  model.boundary_conditions[3].fixed      = {};
  model.boundary_conditions[3].named_free = true;
  expect_message(message_of(mesh.mesh, model),
                 {"free to move in x and free to move in y and free to rotate"});
  mesh.name_point("pin", 2., 2.);
  hold(model, "pin", "xy");
  expect_message(message_of(mesh.mesh, model), {"Body 'upper'", "free to rotate about (2, 2)"});
}


TEST(InputChecks, boundaries)
{
  BlockMesh mesh        = two_blocks();
  ModelDefinition model = two_block_model();
  model.boundary_conditions.pop_back();
  expect_message(message_of(mesh.mesh, model), {"'free'", "no condition", "name it free"});
  hold(model, "nowhere", "x");
  expect_message(message_of(mesh.mesh, model), {"'nowhere'", "Boundaries: base, J-, side, J+"});
  model.boundary_conditions.back().boundary = "bsae";
  expect_message(message_of(mesh.mesh, model), {"'bsae'", "Did you mean 'base'?"});
  model = two_block_model();
  hold(model, "J+", "x");
  expect_message(message_of(mesh.mesh, model), {"'J+' is a lip"});
  model = two_block_model();
  add_load(model, LoadKind::displacement, {"side"}, {"0", "1"});
  expect_message(message_of(mesh.mesh, model), {"moves 'side' in y", "not held"});
  model = two_block_model();
  model.materials.pop_back();
  expect_message(message_of(mesh.mesh, model), {"'upper' has no materials"});
  model = two_block_model();
  mesh.mesh.faces.pop_back();
  expect_message(message_of(mesh.mesh, model), {"1 faces of the outer boundary", "(-1, 1.66667)"});
}


// All wrong names at once; what may follow from them, a body or a boundary left over, is not told.
TEST(InputChecks, several_names)
{
  BlockMesh mesh                            = two_blocks();
  ModelDefinition model                     = two_block_model();
  model.materials.back().body               = "uper";
  model.boundary_conditions.back().boundary = "fre";
  add_load(model, LoadKind::pressure, {"bsae"}, {"1"});
  const std::string message = message_of(mesh.mesh, model);
  expect_message(message,
                 {"'uper': the mesh has no such body",
                  "'fre' is not in the mesh",
                  "there is no boundary 'bsae'",
                  "3 errors"});
  EXPECT_EQ(message.find("no condition"), std::string::npos) << message;
  EXPECT_EQ(message.find("no materials"), std::string::npos) << message;
}


TEST(InputChecks, lips_that_do_not_match)
{
  BlockMesh mesh;
  mesh.add_block("lower", 6, 2, rectangle(-1., 2., -1., 0.), {{"base", "side", "J-", "side"}});
  mesh.add_block("upper", 5, 3, rectangle(-1., 2., 0., 2.), {{"J+", "free", "top", "free"}});
  mesh.add_joint("J", "J+", "J-");
  expect_message(message_of(mesh.mesh, two_block_model()),
                 {"Joint 'J'", "plus lip at (-0.7, 0)", "same division"});
}


TEST(InputChecks, support_oblique_to_the_joint)
{
  const auto line = [](const double x) { return 0.2 * x; };
  BlockMesh mesh;
  mesh.add_block("lower",
                 2,
                 2,
                 [=](double s, double r) {
                   return std::array<double, 2>{{s, (1. + line(s)) * r}};
                 },
                 {{"base", "side", "J-", "free"}});
  mesh.add_block("upper",
                 2,
                 2,
                 [=](double s, double r) {
                   return std::array<double, 2>{{s, 1. + line(s) + (1. - line(s)) * r}};
                 },
                 {{"J+", "side", "free", "free"}});
  mesh.add_joint("J", "J+", "J-");
  ModelDefinition model;
  add_material(model, "lower", 1., 0.2);
  add_material(model, "upper", 1., 0.2);
  hold(model, "base", "xy");
  hold(model, "side", "x");
  hold(model, "free", "");
  expect_message(message_of(mesh.mesh, model), {"Joint 'J' at (1, 1.2)", "oblique"});
}


TEST(InputChecks, loads)
{
  const BlockMesh mesh  = two_blocks();
  ModelDefinition model = two_block_model();
  add_load(model, LoadKind::pressure, {"top"}, {"2*("});
  add_load(model, LoadKind::pressure, {"top"}, {"1/(x-x)"});
  add_load(model, LoadKind::point_force, {}, {"1", "0"});
  model.loads.back().has_coordinates = true;
  model.loads.back().coordinates     = {{0.1, 2., 0.}};
  const CondensedSystem<2> system(mesh.mesh, model, {false});
  EXPECT_THROW(system.assemble_load(2, 0.), InputError);
  EXPECT_THROW(system.assemble_load(3, 0.), InputError);
  try
    {
      system.assemble_load(4, 0.);
      FAIL();
    }
  catch (const InputError &error)
    {
      expect_message(error.what(), {"nearest one is at (0, 2)"});
    }
  EXPECT_TRUE(
    depends_on_time(LoadDefinition{"", LoadKind::weight, {}, {"0", "-sin(t)"}, false, {}, ""}));
  EXPECT_FALSE(
    depends_on_time(LoadDefinition{"", LoadKind::weight, {}, {"0", "-tan(x)"}, false, {}, ""}));
}
