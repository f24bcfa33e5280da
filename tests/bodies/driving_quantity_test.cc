// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Values by hand from the definitions of levels, factors and searches for safety.

#include <fuga/bodies/program/driving_quantity.h>
#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  LoadDefinition
  load(const std::string &name, const LoadKind kind)
  {
    LoadDefinition result;
    result.name = name;
    result.kind = kind;
    return result;
  }

  StageDefinition
  stage(const StagePurpose purpose, const double largest_factor = 1.)
  {
    StageDefinition result;
    result.purpose        = purpose;
    result.largest_factor = largest_factor;
    return result;
  }

  /** Weight; a reservoir that rises from 0 to 20 m; a push to three times its size; a rest; then
   * both searches for safety. The uplift, later in the list, has the level of the reservoir. */
  ModelDefinition
  dam()
  {
    ModelDefinition model;
    model.loads = {load("dead", LoadKind::weight),
                   load("push", LoadKind::pressure),
                   load("reservoir", LoadKind::depth_pressure),
                   load("uplift", LoadKind::uplift)};
    for (const std::size_t i : {2, 3})
      model.loads[i].depth.level_table = {{{1., 0.}}, {{2., 20.}}};
    model.stages.assign(4, stage(StagePurpose::loading));
    model.stages.push_back(stage(StagePurpose::strength_reduction, 2.));
    model.stages.push_back(stage(StagePurpose::load_factor, 5.));
    return model;
  }

  /** Factors of the loads at the ends of the stages. */
  LoadHistory
  factors_of_dam(const double of_water)
  {
    const Vector water = {1., 0., of_water, of_water}, pushed = {1., 3., of_water, of_water};
    return {{0., 1., 2., 3., 4., 5., 6.},
            {{0., 0., of_water, of_water}, water, water, pushed, pushed, pushed, pushed}};
  }
} // namespace

TEST(DrivingQuantity, OfEveryKindOfStage)
{
  const ModelDefinition model = dam();
  const DrivingQuantities driving(model, factors_of_dam(1.));
  const auto expect =
    [&](const double t, const std::size_t number, const std::string &name, const double value) {
      const DrivingQuantity quantity = driving.at(t, number);
      EXPECT_EQ(quantity.name, name);
      EXPECT_DOUBLE_EQ(quantity.value, value);
    };
  expect(0.5, 0, "factor of dead", 0.5);
  expect(1.25, 1, "level of reservoir", 5.);
  expect(2., 1, "level of reservoir", 20.);
  expect(2., 2, "factor of push", 0.);
  expect(2.5, 2, "factor of push", 1.5);
  expect(3.5, 3, "fraction of the stage", 0.5);
  expect(4.5, 4, "F", 4. / 3.); // 1/F falls linearly to 1/2
  expect(5., 4, "F", 2.);
  expect(5.25, 5, "load factor", 2.); // grows linearly to 5
  EXPECT_EQ(driving.at(4.5, 4).text(), "F = 1.33333");
}

TEST(DrivingQuantity, LevelOfALoadThatDoesNotAct)
{
  const ModelDefinition model = dam();
  EXPECT_EQ(DrivingQuantities(model, factors_of_dam(0.)).at(1.5, 1).name, "fraction of the stage");
}
