// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "mesh_builder.h"

using namespace fuga;
using namespace fuga_tests;

// No numbers: the sentences name the group, what exists, the place and the remedy.
TEST(JointSplitter, ComplainsAboutLines)
{
  MeshBuilder builder = two_rows(3, 2);
  builder.chain("base", 11, {4, 5, 6, 7});
  builder.chain("bottom", 12, {0, 1, 2, 3});
  const JointDefinition good = line_joint("base", "upper", "lower");
  expect_joint_complaint(
    builder, {}, {"'base' lies inside", "(0.5, 1)", "'lower' and 'upper'", "no joint uses it"});
  expect_joint_complaint(builder,
                         {line_joint("basis", "upper", "lower")},
                         {"no group of faces 'basis'", "'base', 'bottom'"});
  expect_joint_complaint(builder,
                         {line_joint("bsae", "upper", "lower")},
                         {"no group of faces 'bsae'", "Did you mean 'base'?"});
  expect_joint_complaint(
    builder, {line_joint("base", "uper", "lower")}, {"no body 'uper'", "Did you mean 'upper'?"});
  expect_joint_complaint(
    builder, {line_joint("base", "upper", "soil")}, {"no body 'soil'", "'lower', 'upper'"});
  expect_joint_complaint(builder,
                         {line_joint("base", "upper", "upper")},
                         {"between 'lower' and 'upper', but", "(0.5, 1)"});
  expect_joint_complaint(builder,
                         {line_joint("bottom", "upper", "lower")},
                         {"'bottom' is on the outer boundary", "(0.5, 0)"});
  JointDefinition again = line_joint("base", "upper", "soil");
  again.name            = "again";
  expect_joint_complaint(
    builder,
    {line_joint("basis", "upper", "lower"), again},
    {"no group of faces 'basis'", "joint 'again'", "no body 'soil'", "2 errors"});
  again      = good;
  again.name = "again";
  expect_joint_complaint(builder, {good, again}, {"joint 'again'", "already that of joint 'base'"});
  expect_joint_complaint(builder, {good, good}, {"two joints of this name"});
  expect_joint_complaint(builder,
                         {lip_joint("j", "base", "")},
                         {"'base' lies inside", "not open there", "state it as line"});
  builder.chain("base+", 13, {8, 9});
  expect_joint_complaint(builder, {good}, {"'base+'", "rename"});
  builder.chain("other", 14, {1, 2});
  expect_joint_complaint(builder, {good}, {"'bottom' and 'other'", "(1.5, 0)", "allowed is one"});
  builder.mesh.faces.pop_back();
  builder.chain("diagonal", 15, {0, 5});
  expect_joint_complaint(builder, {good}, {"'diagonal'", "(0.5, 0.5)", "face of no cell"});
}


// No numbers: the sentences name the place and the remedy.
TEST(JointSplitter, ComplainsAboutCracks)
{
  MeshBuilder builder = MeshBuilder::grid(4, 2);
  builder.chain("crack", 11, {6, 7});
  expect_joint_complaint(
    builder, {line_joint("crack", "plate", "plate")}, {"(1.5, 1)", "cannot open", "refine"});
  builder.chain("crack", 11, {8, 7});
  expect_joint_complaint(builder,
                         {line_joint("crack", "plate", "plate")},
                         {"different directions", "(2, 1)", "minus sign"});
}


// No numbers: every contradiction within a definition has its sentence.
TEST(JointSplitter, ComplainsAboutDefinitions)
{
  const MeshBuilder builder = open_pair(1);
  const auto expect         = [&](const JointDefinition &joint, const std::string &part) {
    expect_joint_complaint(builder, {joint}, {part});
  };
  JointDefinition joint = lip_joint("j", "base", "top");
  joint.name.clear();
  expect(joint, "no name");
  joint      = lip_joint("j", "base", "top");
  joint.line = "top";
  expect(joint, "both a line and lips");
  expect(lip_joint("j", "", ""), "neither a line nor lips");
  expect(lip_joint("j", "", "top"), "no plus lip");
  joint               = lip_joint("j", "base", "top");
  joint.against_rigid = true;
  expect(joint, "although it is against a rigid obstacle");
  joint               = lip_joint("j", "base", "");
  joint.against_rigid = false;
  expect(joint, "no minus lip");
  joint               = line_joint("top", "upper", "lower");
  joint.against_rigid = true;
  expect(joint, "cannot be against a rigid");
  expect(line_joint("top", "", "lower"), "not both bodies");
  expect(lip_joint("j", "base", "base"), "already part of a joint");
  expect(lip_joint("j", "base", "bottom"), "no group of faces 'bottom'");
  expect_parts(complaint([] { split_joints(GmshMesh(), {}); }), {"no cells"});
  MeshBuilder nameless = open_pair(1);
  nameless.mesh.physical_names.clear();
  expect_joint_complaint(nameless, {}, {"tag 1", "no name", "Physical Surface"});
}
