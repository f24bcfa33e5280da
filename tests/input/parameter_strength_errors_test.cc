// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::replaced;
    using testing_files::WrongInput;

    class WrongStrength : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongStrength, IsExplained)
    {
      expect_explained(GetParam());
    }

    /** More entries behind the friction of joint 'base', f = 0.2. */
    testing_files::Changes
    with(const std::string &entries)
    {
      return {{"set Friction coefficient = 0.2", "set Friction coefficient = 0.2\n" + entries}};
    }

    /** The same for a joint whose laws are linear. */
    testing_files::Changes
    linear_with(const std::string &entries)
    {
      testing_files::Changes changes = with(entries);
      changes.push_back({"    set Normal law = cubic root\n", ""});
      return changes;
    }

    const WrongInput strengths[] = {
      {"ResidualAbovePeak",
       with("set Residual friction coefficient = 0.3"),
       {},
       {"Residual friction coefficient = '0.3'", "above the friction 0.2", "not gained"}},
      {"ResidualTwice",
       with("set Residual friction coefficient = 0.1\nset Residual friction angle = 5"),
       {},
       {"'Residual friction angle' is given as well", "Keep one"}},
      {"TensionBeyondTheTip",
       with("set Cohesion = 0.1\nset Tensile strength = 0.6"),
       {},
       {"Tensile strength = '0.6'", "tip of Coulomb's cone", "0.5"}},
      {"DilatancyAboveFriction",
       with("set Dilatancy angle = 20"),
       {},
       {"Dilatancy angle = '20'", "would create energy"}},
      {"DilatancyAboveResidualFriction",
       with("set Dilatancy angle = 8\nset Residual friction coefficient = 0.1"),
       {},
       {"Dilatancy angle = '8'", "would create energy"}},
      {"EnvelopeWithoutPressure",
       with("set Envelope exponent = 0.7"),
       {},
       {"Envelope exponent = '0.7'", "'Envelope pressure' is missing"}},
      {"EnvelopeWithoutExponent",
       with("set Envelope pressure = 0.7"),
       {},
       {"Envelope pressure = '0.7'", "'Envelope exponent' is missing"}},
      {"EnvelopeThatRises",
       with("set Envelope exponent = 1.2\nset Envelope pressure = 0.7"),
       {},
       {"Envelope exponent = '1.2'", "to 1"}},
      {"LimitWithoutDilatancy",
       with("set Dilation limit = 0.01"),
       {},
       {"Dilation limit = '0.01'", "'Dilatancy angle' is 0"}},
      {"BondLossWithoutBond", with("set Bond lost by = slip"), {}, {"Bond lost by", "no bond"}},
      {"UnknownBondLoss",
       with("set Bond lost by = magic"),
       {},
       {"Bond lost by = 'magic'", "opening", "slip"}},
      {"GrowthWithoutScale",
       linear_with("set Shear stiffness grows with = closure"),
       {},
       {"Shear stiffness grows with = 'closure'", "'Shear growth closure' is missing"}},
      {"GrowthOfTheOtherKind",
       linear_with("set Shear stiffness grows with = closure\nset Shear growth pressure = 1"),
       {},
       {"Shear growth pressure = '1'", "does not use this entry"}},
      {"GrowthOfNothing",
       linear_with("set Shear growth closure = 0.001"),
       {},
       {"Shear growth closure = '0.001'", "remove this entry"}},
      {"ExponentAboveOne",
       linear_with("set Shear stiffness grows with = closure\nset Shear growth closure = "
                   "0.001\nset Shear growth exponent = 2"),
       {},
       {"Shear growth exponent = '2'", "1"}},
      {"GrowthWithDilatancy",
       linear_with("set Shear stiffness grows with = closure\nset Shear growth closure = "
                   "0.001\nset Dilatancy angle = 5"),
       {},
       {"Shear stiffness grows with = 'closure'", "not together with 'Dilatancy angle'"}}};

    INSTANTIATE_TEST_SUITE_P(Strengths, WrongStrength, testing::ValuesIn(strengths), name_of);

    // What the entries mean: tan 5°; loss = peak - residual.
    TEST(ParameterStrength, IsRead)
    {
      const std::string file = testing_files::write_file(
        "strength.prm",
        replaced(testing_files::example_prm(),
                 with("set Residual friction coefficient = 0.15\nset Cohesion = 0.5\nset Tensile "
                      "strength = 0.4\nset Bond lost by = slip\nset Dilatancy angle = 5\nset "
                      "Dilation limit = 0.003\nset Envelope exponent = 0.7\nset Envelope "
                      "pressure = 0.6")));
      const FrictionLaw law = read_parameters(file).joints.at(0).friction;
      EXPECT_EQ(law.coefficient, 0.2);
      EXPECT_NEAR(residual_friction(law), 0.15, 1e-15);
      EXPECT_EQ(law.envelope.exponent, 0.7);
      EXPECT_EQ(law.envelope.pressure, 0.6);
      EXPECT_EQ(law.cohesion, 0.5);
      EXPECT_EQ(law.tensile_strength, 0.4);
      EXPECT_EQ(law.bond_loss, FrictionLaw::BondLoss::slip);
      EXPECT_NEAR(law.dilatancy, 0.08748866352592401, 1e-15);
      EXPECT_EQ(law.dilation_limit, 0.003);
    }
  } // namespace
} // namespace fuga
