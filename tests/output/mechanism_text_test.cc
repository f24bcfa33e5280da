// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Jumps of rigid motions, written down by hand: v + w e_z x r resolved along normals and tangents.

#include <fuga/output/results/mechanism_text.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

namespace
{
  using Place = std::array<double, 2>;

  /** Two joints with three elements each, in the plane: 0 on y = 0 with the normal upwards, 1 on
   * x = 0 with the normal to the right. */
  class TwoJoints : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      for (unsigned int joint = 0; joint < 2; ++joint)
        for (unsigned int i = 0; i < 3; ++i)
          {
            ContactElement element;
            element.joint          = joint;
            element.number         = i;
            element.normal_bar     = 2 * static_cast<unsigned int>(elements.size());
            element.tangential_bar = element.normal_bar + 1;
            element.area           = i == 1 ? 2. : 1.;
            if (joint == 0)
              element.position = {{1. * i, 0., 0.}};
            else
              element.position = {{0., -1. * i, 0.}};
            elements.push_back(element);
            frames.push_back(joint == 0 ? ElementFrame{{{0., 1., 0.}}, {{{{1., 0., 0.}}, {}}}}
                                        : ElementFrame{{{1., 0., 0.}}, {{{{0., -1., 0.}}, {}}}});
          }
      jumps.assign(12, 0.);
    }

    /** The plus faces move with @p v and turn with @p w about @p centre. */
    void
    move(const unsigned int joint, const Place &v, const double w, const Place &centre)
    {
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (elements[k].joint == joint)
          {
            const auto &x                     = elements[k].position;
            const double u0                   = v[0] - w * (x[1] - centre[1]);
            const double u1                   = v[1] + w * (x[0] - centre[0]);
            jumps[elements[k].normal_bar]     = joint == 0 ? u1 : u0;
            jumps[elements[k].tangential_bar] = joint == 0 ? u0 : -u1;
          }
    }

    std::string
    text() const
    {
      return mechanism_text(joint_motions(2, elements, frames, jumps, false),
                            {"seam", "heel crack"});
    }

    std::vector<ContactElement> elements;
    std::vector<ElementFrame> frames;
    Vector jumps;
  };
} // namespace

TEST_F(TwoJoints, SlidingOnOneOpensTheOther)
{
  move(0, {{1., 0.}}, 0., {{0., 0.}});
  EXPECT_EQ(text(), "slides on 'seam'");
  move(1, {{1., 0.}}, 0., {{0., 0.}});
  EXPECT_EQ(text(), "slides on 'seam'; 'heel crack' opens");
}

TEST_F(TwoJoints, RoughJointOpensAndSlides)
{
  move(0, {{1., 0.2}}, 0., {{0., 0.}});
  EXPECT_EQ(text(), "'seam' opens and slides");
}

// A block that hangs above its base, and one that is left on an edge of it.
TEST_F(TwoJoints, LipsThatApproach)
{
  move(0, {{0., -1.}}, 0., {{0., 0.}});
  EXPECT_EQ(text(), "'seam' closes");
  move(0, {{0., 0.}}, 0.5, {{2., 0.}});
  EXPECT_EQ(text(), "'seam' closes, turning about (2, 0)");
}

// A block that tips over its corner (2, 0) opens the base and does not slide on it.
TEST_F(TwoJoints, TippingAboutACorner)
{
  move(0, {{0., 0.}}, -0.5, {{2., 0.}});
  EXPECT_EQ(text(), "'seam' opens, turning about (2, 0)");
}

TEST_F(TwoJoints, TurningAboutAPointBesideTheJoint)
{
  move(0, {{0., 0.}}, -0.2, {{3., -1.}});
  EXPECT_EQ(text(), "'seam' opens and slides, turning about (3, -1)");
}

// Both halves of a joint turn differently: there is no one point.
TEST_F(TwoJoints, BentJointHasNoCentre)
{
  jumps[elements[0].normal_bar] = 1.;
  jumps[elements[2].normal_bar] = 1.;
  EXPECT_EQ(text(), "'seam' opens, turning");
}

TEST_F(TwoJoints, RoundingIsNoMotion)
{
  move(0, {{1., 0.}}, 1e-9, {{0., 0.}});
  move(1, {{1e-5, 0.}}, 0., {{0., 0.}});
  EXPECT_EQ(text(), "slides on 'seam'");
  jumps.assign(12, 0.);
  EXPECT_EQ(text(), "");
}
