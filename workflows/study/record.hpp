#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/options/value.hpp"
#include "problem/problem.hpp"
#include "report/text/columns.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::study {

/// L1 distances of the two marginal densities.
struct MarginalL1 {
  double y, ydot;
};

/// A row of a study for files and tables: values under paths such as "observed_order.l1".
using Record = base::Values;

/// A member of an optional struct as a value; empty where the struct is.
template <class Owner>
base::Value value(const std::optional<Owner>& owner, double Owner::*member) {
  return owner ? base::Value((*owner).*member) : base::Value();
}

/// Adds the fields status, reason, seconds, l1_y and l1_ydot.
void add_outcome(const transform::Solution& solution, const std::optional<MarginalL1>& l1,
                 Record& record);

/// A column of a table: the values under one path.
struct TableColumn {
  std::string group, header, path;
  const char* format;  ///< format of numbers, for fmt
  int importance = report::kAlwaysShown;
  bool left_aligned = false;
};

/// Table of the rows. Absent values and numbers that are not finite are a dash. The column "status"
/// has its own kind.
std::string table_text(const std::vector<Record>& rows, const std::vector<TableColumn>& columns,
                       const report::TextFormat& format);

/// CSV of the rows, with a header. Absent values and numbers that are not finite are empty.
/// @param columns paths separated by blanks; NAME=PATH where the header has another name
std::string csv_text(const std::vector<Record>& rows, const std::string& columns);

/// JSON of a study: schema, program, study, the case as in summary.json, the fields of `itself`,
/// and the named lists of rows.
std::string study_json(const std::string& study, const problem::Problem& problem,
                       const std::string& command, const Record& itself,
                       const std::vector<std::pair<std::string, std::vector<Record>>>& lists);

/// The record of each row.
template <class Row>
std::vector<Record> records(const std::vector<Row>& rows) {
  std::vector<Record> all;
  for (const Row& row : rows) all.push_back(record(row));
  return all;
}

/// A number for a sentence or a cell; a dash for absent numbers and numbers that are not finite.
/// @param format format for fmt, e.g. "{:.1e}"
std::string number_text(const std::optional<double>& number, const char* format);

/// Joins items as in "2, 4 and 6".
std::string join_with_and(const std::vector<std::string>& items);

/// For a solution that is not ok: "  NAME STATUS: REASON", wrapped; else empty.
std::string reason_text(const std::string& name, const transform::Solution& solution,
                        std::size_t width);

}  // namespace fpkcheck::study
