// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Header and rows follow from one list; the text by hand after RFC 4180.

#include <fuga/output/files/table.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

using namespace fuga;

TEST(Table, HeaderAndRowsFromOneList)
{
  struct Row
  {
    std::string name;
    double length;
    std::size_t number;
  };
  const std::string path = testing::TempDir() + "fuga_table.csv";
  Columns<Row> columns   = {{"joint", "", [](const Row &row) { return row.name; }},
                            {"gap", "m", [](const Row &row) { return row.length; }}};
  append(columns, {{"count", "", [](const Row &row) { return row.number; }}});
  Table<Row> table(path, columns);
  table.add({"base", 0.5, 2});
  table.add({"a \"b\", c", std::numeric_limits<double>::quiet_NaN(), 10});
  table.publish(true);
  EXPECT_EQ(read_file(path), "joint,gap[m],count\r\nbase,0.5,2\r\n\"a \"\"b\"\", c\",nan,10\r\n");
  std::filesystem::remove(path);
}
