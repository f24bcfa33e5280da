// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/archive.h>
#include <fuga/output/restart/checkpoint.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace fuga;

namespace
{
  std::uint64_t
  bits(const double value)
  {
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof(result));
    return result;
  }

  /** Through the binary form and back. */
  template <typename Value>
  Value
  stored(const Value &value)
  {
    using archive::Json;
    Value result{};
    archive::decode(Json::from_cbor(Json::to_cbor(archive::encode(value))), result);
    return result;
  }

  /** Numbers that text, or JSON as such, would change. */
  std::vector<double>
  awkward_numbers()
  {
    using Limits = std::numeric_limits<double>;
    return {0.,
            -0.,
            0.1,
            1. / 3.,
            Limits::denorm_min(),
            Limits::max(),
            Limits::infinity(),
            -Limits::infinity(),
            Limits::quiet_NaN(),
            -Limits::quiet_NaN(),
            1e23,
            1.5,
            std::nextafter(1., 2.)};
  }
} // namespace

TEST(Archive, NumbersComeBackBitForBit)
{
  const Vector numbers = awkward_numbers();
  const Vector all     = stored(numbers);
  ASSERT_EQ(all.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      EXPECT_EQ(bits(all[i]), bits(numbers[i]));
      EXPECT_EQ(bits(stored(numbers[i])), bits(numbers[i]));
    }
  const std::size_t large = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(stored(large), large);
  EXPECT_TRUE(stored(Vector()).empty());
}

TEST(Archive, OtherKindsComeBack)
{
  const std::vector<bool> flags           = {true, false, true};
  const std::vector<ContactState> states  = {ContactState::slip_backward, ContactState::open};
  const std::array<std::size_t, 4> counts = {{1, 2, 3, 4}};
  const std::string text                  = "фуга, \"quoted\"\r\n";
  const std::vector<std::pair<double, std::string>> collection = {{0.1, "a"}, {-0., text}};
  const std::map<std::string, std::size_t> kinds               = {{"stick -> slip", 3}};
  EXPECT_EQ(stored(flags), flags);
  EXPECT_EQ(stored(states), states);
  EXPECT_EQ(stored(counts), counts);
  EXPECT_EQ(stored(text), text);
  EXPECT_EQ(stored(collection), collection);
  EXPECT_EQ(stored(kinds), kinds);
  EXPECT_EQ(stored(Verdict::limit_load), Verdict::limit_load);
  EXPECT_EQ(stored(true), true);
}

// A whole checkpoint: the bytes of what was read are those of what was written.
TEST(Archive, Checkpoint)
{
  Checkpoint checkpoint;
  checkpoint.parameters          = {{"Bodies/a/Young modulus", "3060"}, {"Title", "фуга"}};
  checkpoint.mesh                = {12345, 0xfedcba98u};
  checkpoint.cut.state.forces    = awkward_numbers();
  checkpoint.cut.state.strengths = {{0.1, 0.2, 0.3, 0.4}, {}};
  checkpoint.cut.state.states    = {ContactState::stick, ContactState::slip_forward};
  checkpoint.cut.memory.scheme.exchanges = {
    {7, {}},
    {RowExchange::none,
     {SchemeRow::Demand::layer, 3, 1, {{2., 0.1, -0.}}, {{1e300, 4., 0.}}, {{1., 0., 0.}}}}};
  checkpoint.cut.resticking    = {5, 3};
  checkpoint.cut.n_reports     = 17;
  checkpoint.judge.ledger      = {0.1, 0.2, 0.3, std::nan("")};
  checkpoint.judge.on_track    = false;
  checkpoint.record.worst.cone = 1e-16;
  checkpoint.tables.files      = {{"events.csv", {{10, 3}, "1,2\r\n"}}};
  checkpoint.log.warnings      = {"w"};
  const Checkpoint read        = stored(checkpoint);
  const archive::Json a = archive::encode(checkpoint), b = archive::encode(read);
  EXPECT_TRUE(archive::Json::to_cbor(a) == archive::Json::to_cbor(b));
  EXPECT_EQ(read.cut.memory.scheme.exchanges[1].appended,
            checkpoint.cut.memory.scheme.exchanges[1].appended);
  EXPECT_EQ(read.cut.n_reports, 17u);
  EXPECT_FALSE(read.judge.on_track);
  EXPECT_EQ(read.log.warnings, checkpoint.log.warnings);
}

// A field less, one of another kind, or bytes too few are noticed.
TEST(Archive, OtherLayoutIsNoticed)
{
  archive::Json json = archive::encode(Checkpoint());
  Checkpoint checkpoint;
  EXPECT_NO_THROW(archive::decode(json, checkpoint));
  archive::Json less = json;
  less["cut"]["state"].erase("slips");
  EXPECT_ANY_THROW(archive::decode(less, checkpoint));
  archive::Json other       = json;
  other["cut"]["n_reports"] = "many";
  EXPECT_ANY_THROW(archive::decode(other, checkpoint));
  archive::Json short_bytes            = json;
  short_bytes["cut"]["state"]["slips"] = archive::Json::binary({1, 2, 3});
  EXPECT_ANY_THROW(archive::decode(short_bytes, checkpoint));
}

// A record may be another one under the same name.
TEST(Checkpoint, ToldByTheMotionOfTheGround)
{
  Parameters parameters;
  parameters.echo = {{"Title", "a"}};
  EXPECT_EQ(description_of_problem(parameters), parameters.echo);
  Vector &a        = parameters.model.dynamics.ground[1].accelerations;
  a                = {0., 1., 2.};
  const auto first = description_of_problem(parameters);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1].first, "the motion of the ground along y");
  EXPECT_EQ(description_of_problem(parameters), first);
  a[2] = std::nextafter(2., 3.);
  EXPECT_NE(description_of_problem(parameters), first);
}
