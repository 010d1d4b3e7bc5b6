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

/// L1 distances of both marginals.
struct MarginalL1 {
  double y, ydot;
};

/// A row of a study as files and tables have it: values under paths such as "observed_order.l1".
using Record = base::Values;

/// A member of what may not be there.
template <class Owner>
base::Value value(const std::optional<Owner>& owner, double Owner::*member) {
  return owner ? base::Value((*owner).*member) : base::Value();
}

/// Adds status, reason, seconds, l1_y and l1_ydot.
void add_outcome(const transform::Solution& solution, const std::optional<MarginalL1>& l1,
                 Record& record);

/// A column of a table: the values under a path.
struct Shown {
  std::string group, header, path;
  const char* format;  ///< of numbers
  int importance = report::kAlwaysShown;
  bool left_aligned = false;
};

/// A dash for what is absent or not finite. Statuses are a column of their own kind.
std::string table_of(const std::vector<Record>& rows, const std::vector<Shown>& columns,
                     const report::TextFormat& format);

/// Under a header; empty where there is nothing, or nothing finite.
/// @param columns their paths, with blanks between them; NAME=PATH where the header has another
/// name
std::string csv_of(const std::vector<Record>& rows, const std::string& columns);

/// The JSON of a study: schema, program, study, the case as in summary.json, what is said of the
/// study itself, and lists of rows by their names.
std::string json_of(const std::string& study, const problem::Problem& problem,
                    const std::string& command, const Record& itself,
                    const std::vector<std::pair<std::string, std::vector<Record>>>& lists);

/// The records of several rows.
template <class Row>
std::vector<Record> records(const std::vector<Row>& rows) {
  std::vector<Record> all;
  for (const Row& row : rows) all.push_back(record(row));
  return all;
}

/// A number in a sentence or a cell, a dash where there is none or it is not finite.
/// @param format of fmt, e.g. "{:.1e}"
std::string number_text(const std::optional<double>& number, const char* format);

/// "2, 4 and 6"
std::string listed(const std::vector<std::string>& items);

/// What is to be said of a solution that is not ok: "  NAME STATUS: REASON", wrapped; else nothing.
std::string reason_text(const std::string& name, const transform::Solution& solution,
                        std::size_t width);

}  // namespace fpkcheck::study
