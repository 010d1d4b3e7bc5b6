#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/options/parameter_value.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_layout.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::study {

struct MarginalL1Distances {
  double y, ydot;
};

/// Values of one row in the results of a study, for files and tables. Each value of a StudyRecord
/// has a path such as "observed_order.l1".
using StudyRecord = base::Values;

template <class Owner>
base::Value optional_member_value(const std::optional<Owner>& owner, double Owner::*member) {
  return owner ? base::Value((*owner).*member) : base::Value();
}

/// Adds the fields status, reason, seconds, l1_y and l1_ydot of a solution to a record.
void add_status_and_distances(const transform::Solution& solution,
                              const std::optional<MarginalL1Distances>& l1, StudyRecord& record);

/// Column of a text table, which shows the values with the same path in all records.
struct StudyTableColumn {
  std::string group, header, path;
  const char* format;  ///< format of numbers for the library fmt
  int importance = report::kAlwaysShown;
  bool left_aligned = false;
};

/// Returns the records as a text table. In a table of study records, a dash represents an absent
/// value or a number that is not finite.
std::string records_table_text(const std::vector<StudyRecord>& rows,
                               const std::vector<StudyTableColumn>& columns,
                               const report::TerminalTextFormat& format);

/// Returns the records of a study as CSV with a header. In the CSV, absent values and numbers that
/// are not finite are empty fields, and texts with separators are enclosed in quotes.
/// @param columns paths of the columns, separated by blanks, or NAME=PATH for a column whose header
///        differs from its path
std::string records_csv_text(const std::vector<StudyRecord>& rows, const std::string& columns);

/// Returns the JSON text of a study. The argument `study_values` has values of the whole study,
/// such as the options of the study.
std::string study_records_to_json(
    const std::string& study, const problem::Problem& problem, const std::string& command,
    const StudyRecord& study_values,
    const std::vector<std::pair<std::string, std::vector<StudyRecord>>>& lists);

template <class Row>
std::vector<StudyRecord> make_study_records(const std::vector<Row>& rows) {
  std::vector<StudyRecord> all;
  for (const Row& row : rows) all.push_back(make_study_record(row));
  return all;
}

/// Returns the text of a number, or a dash if the number is missing or not finite.
/// @param format format for fmt, e.g. "{:.1e}"
std::string number_text(const std::optional<double>& number, const char* format);

/// Joins texts to an enumeration such as "2, 4 and 6".
std::string join_with_and(const std::vector<std::string>& items);

/// Returns the name, the status and the reason for the status of a solution as wrapped lines; empty
/// for the status `ok`.
std::string status_reason_text(const std::string& name, const transform::Solution& solution,
                               std::size_t width);

/// Makes a plot series from each group of neighbouring rows with equal names, where the functions
/// `name` and `point` return the name and the point of a row. Each plot series has the style of the
/// solution in the middle row of its group.
template <class Row, class Name, class Point>
std::vector<report::FigureSeries> make_empty_figure_series(const std::vector<Row>& rows, Name name,
                                                           Point point) {
  std::vector<report::FigureSeries> all;
  for (auto row = rows.begin(); row != rows.end();) {
    const auto first = row;
    std::vector<report::FigurePoint> points;
    for (; row != rows.end() && name(*row) == name(*first); ++row) {
      if (const std::optional<report::FigurePoint> place = point(*row)) points.push_back(*place);
    }
    const auto middle = first + (row - first - 1) / 2;
    all.push_back(
        report::make_empty_figure_series(name(*first), middle->solution.identity.plot_style));
    all.back().points = points;
  }
  return all;
}

}  // namespace fpkcheck::study
