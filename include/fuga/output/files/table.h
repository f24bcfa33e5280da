// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_table_h
#define fuga_output_files_table_h

#include <fuga/output/files/output_files.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <variant>

namespace fuga
{
  /** The content of one field of a table. */
  using TableField = std::variant<double, std::size_t, std::string>;

  /** Return a line of CSV (RFC 4180): numbers with 17 digits, words quoted if necessary. */
  std::string
  csv_line(const std::vector<TableField> &fields);

  /** A column of a table: header and fields are defined in one place and cannot disagree. */
  template <typename Row>
  struct Column
  {
    std::string name;
    /** The unit, which follows the name in brackets; empty for words, counts and ratios. */
    std::string unit;
    /** Returns the field of this column in a row. */
    std::function<TableField(const Row &)> field;
  };

  template <typename Row>
  using Columns = std::vector<Column<Row>>;

  /** A file of rows that all have the same columns. */
  template <typename Row>
  class Table : public TextFile
  {
  public:
    /** Create a table with its header, which is not yet published. */
    Table(std::string file_path, Columns<Row> table_columns)
      : TextFile(std::move(file_path)), columns(std::move(table_columns))
    {
      std::vector<TableField> header;
      for (const Column<Row> &column : columns)
        header.emplace_back(column.name + (column.unit.empty() ? "" : "[" + column.unit + "]"));
      append(csv_line(header));
    }

    void
    add(const Row &row)
    {
      std::vector<TableField> fields;
      for (const Column<Row> &column : columns)
        fields.push_back(column.field(row));
      append(csv_line(fields));
    }

  private:
    const Columns<Row> columns;
  };

  /**
   * Return columns of a part that rows of several tables contain: those of @p described whose names
   * are listed in @p names, separated by blanks. @p part_of returns the part of a row. @p prefix is
   * put in front of the names.
   */
  template <typename Row, typename Part, typename PartOf>
  Columns<Row>
  columns_of(const Columns<Part> &described,
             const std::string &names,
             const PartOf &part_of,
             const std::string &prefix = "")
  {
    Columns<Row> columns;
    std::istringstream words(names);
    for (std::string name; words >> name;)
      {
        const auto one =
          std::find_if(described.begin(), described.end(), [&name](const Column<Part> &column) {
            return column.name == name;
          });
        AssertThrow(one != described.end(), dealii::ExcMessage("no column " + name));
        columns.push_back({prefix + name, one->unit, [field = one->field, part_of](const Row &row) {
                             return field(part_of(row));
                           }});
      }
    return columns;
  }

  /** Append @p more to @p columns. */
  template <typename Row>
  void
  append(Columns<Row> &columns, const Columns<Row> &more)
  {
    columns.insert(columns.end(), more.begin(), more.end());
  }
} // namespace fuga

#endif
