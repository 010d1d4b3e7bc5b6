#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/options/parameter.hpp"
#include "problem/problem.hpp"
#include "report/text/columns.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::study {

/// L1 distances of the two marginal densities.
struct MarginalL1Distances {
  double y, ydot;
};

/// A row of a study for files and tables. The values have paths such as "observed_order.l1".
using Record = base::Values;

/// The value of a member of an optional struct; empty if the struct is absent.
template <class Owner>
base::Value value(const std::optional<Owner>& owner, double Owner::*member) {
  return owner ? base::Value((*owner).*member) : base::Value();
}

/// Adds the fields status, reason, seconds, l1_y and l1_ydot of a solution to a record.
void add_outcome(const transform::Solution& solution, const std::optional<MarginalL1Distances>& l1,
                 Record& record);

/// A column of a table: the values under one path.
struct TableColumn {
  std::string group, header, path;
  const char* format;  ///< format of numbers, for fmt
  int importance = report::kAlwaysShown;
  bool left_aligned = false;
};

/// A text table of the records. A dash stands for an absent value or a number that is not finite.
/// The column "status" is formatted as a column of statuses.
std::string table_text(const std::vector<Record>& rows, const std::vector<TableColumn>& columns,
                       const report::TextFormat& format);

/// The records in CSV with a header. Absent values and numbers that are not finite have an empty
/// field.
/// @param columns paths of the columns, separated by blanks; NAME=PATH for a column whose header
///                differs from the path
std::string csv_text(const std::vector<Record>& rows, const std::string& columns);

/// The JSON of a study: schema, program, name of the study, the case as in summary.json, the fields
/// of the study as a whole, and the named lists of records.
std::string study_json(const std::string& study, const problem::Problem& problem,
                       const std::string& command, const Record& itself,
                       const std::vector<std::pair<std::string, std::vector<Record>>>& lists);

/// The record of each row.
template <class Row>
std::vector<Record> records(const std::vector<Row>& rows) {
  std::vector<Record> all;
  for (const Row& row : rows) all.push_back(make_record(row));
  return all;
}

/// The text of a number for a sentence or a cell; a dash if the number is absent or not finite.
/// @param format format for fmt, e.g. "{:.1e}"
std::string number_text(const std::optional<double>& number, const char* format);

/// Joins texts to an enumeration such as "2, 4 and 6".
std::string join_with_and(const std::vector<std::string>& items);

/// The text " NAME STATUS: REASON" of a solution that is not ok, broken into lines; empty if the
/// solution is ok.
std::string status_reason_text(const std::string& name, const transform::Solution& solution,
                               std::size_t width);

}  // namespace fpkcheck::study
