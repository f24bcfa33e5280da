// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/compliance_law.h>
#include <fuga/output/warnings/model_range.h>
#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  /** A joint of two elements, 4 m apart, and its state. */
  class JointOfTwo : public testing::Test
  {
  protected:
    JointOfTwo()
    {
      for (unsigned int k = 0; k < 2; ++k)
        {
          ContactElement element;
          element.number         = k;
          element.normal_bar     = 2 * k;
          element.tangential_bar = 2 * k + 1;
          element.position       = {{4. * k, 0., 0.}};
          element.normal_law = element.shear_law = law.get();
          elements.push_back(element);
        }
      state.states.assign(2, ContactState::stick);
      state.forces.assign(4, 0.);
      state.dislocations.assign(4, 0.);
      state.slips.assign(2, TangentVector{});
      state.t = 1.5;
    }

    /** @p opening of the second element where @p first is that of the first one. */
    void
    open(const double first, const double second)
    {
      state.states.assign(2, ContactState::open);
      state.dislocations = {first, 0., second, 0.};
    }

    std::vector<std::string>
    warnings()
    {
      ModelRange::Record record;
      ModelRange(elements, 1, record).watch(state);
      return range_warnings<2>(record, {"base"}, Units());
    }

    const std::unique_ptr<ComplianceLaw> law = make_linear_law(1.);
    std::vector<ContactElement> elements;
    JointState state;
  };
} // namespace

TEST_F(JointOfTwo, SmallDisplacementsAreUsual)
{
  state.slips[1] = {{0.19, 0.}};
  open(0., 0.39);
  EXPECT_EQ(warnings(), std::vector<std::string>{});
}

TEST_F(JointOfTwo, LargeSlip)
{
  state.slips[1]                        = {{-0.24, 0.}};
  const std::vector<std::string> spoken = warnings();
  ASSERT_EQ(spoken.size(), 1u);
  for (const char *part :
       {"joint 'base'", "element 1 at (4, 0)", "0.24 m", "t = 1.5", "0.06 times"})
    EXPECT_NE(spoken[0].find(part), std::string::npos) << spoken[0];
}

// A joint of one element is as long as its area says, in space as wide.
TEST_F(JointOfTwo, OneElementHasALength)
{
  elements.resize(1);
  elements[0].area = 0.25;
  state.slips[0]   = {{0.02, 0.}};
  ASSERT_EQ(warnings().size(), 1u);
  EXPECT_NE(warnings()[0].find("0.08 times"), std::string::npos) << warnings()[0];
  elements[0].second_tangential_bar = 2;
  EXPECT_EQ(warnings(), std::vector<std::string>{});
}

// Bodies that fly do not turn.
TEST_F(JointOfTwo, LargeRotation)
{
  open(0.2, 1.);
  const std::vector<std::string> spoken = warnings();
  ASSERT_EQ(spoken.size(), 1u);
  for (const char *part : {"openings differ by 0.8 m", "0.2 times", "less than 0.1"})
    EXPECT_NE(spoken[0].find(part), std::string::npos) << spoken[0];
  open(5., 5.);
  EXPECT_EQ(warnings(), std::vector<std::string>{});
}

// What an earlier phase of construction has seen remains.
TEST_F(JointOfTwo, TheFarthestIsKept)
{
  ModelRange::Record record;
  for (const double slip : {0.3, 0.8, 0.5})
    {
      state.slips[0] = {{slip, 0.}};
      state.t += 1.;
      ModelRange(elements, 1, record).watch(state);
    }
  const std::vector<std::string> spoken = range_warnings<2>(record, {"base"}, Units());
  ASSERT_EQ(spoken.size(), 1u);
  EXPECT_NE(spoken[0].find("0.8 m at t = 3.5"), std::string::npos) << spoken[0];
}
