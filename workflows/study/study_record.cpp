#include "workflows/study/study_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <variant>

#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"
#include "results/marginals_csv.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::study {
namespace {

using base::Value;
using results::Json;

Value value_at(const StudyRecord& record, const std::string& path) {
  const auto found = std::ranges::find(record, path, &base::NamedParameterValue::name);
  return found == record.end() ? Value() : found->value;
}

// Returns the text of a value of a study record. The argument `format` applies to non-integer
// numbers of a study record. A missing value gives an empty text.
std::string value_text(const Value& value, const char* format) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* count = std::get_if<std::int64_t>(&value)) return std::to_string(*count);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr && std::isfinite(*number) ? fmt::format(fmt::runtime(format), *number)
                                                     : std::string();
}

void add_record_to_json(const StudyRecord& record, Json& object) {
  transform::SolverMetricsBuilder values;
  for (const auto& [path, value] : record) values.add_result_metric(path, value);
  results::add_metrics(std::move(values).take_metrics(), object);
}

}  // namespace

void add_status_and_distances(const transform::Solution& solution,
                              const std::optional<MarginalL1Distances>& l1, StudyRecord& record) {
  record.push_back({"status", std::string(name(solution.status))});
  record.push_back({"reason", solution.reason});
  record.push_back({"seconds", solution.seconds});
  record.push_back({"l1_y", optional_member_value(l1, &MarginalL1Distances::y)});
  record.push_back({"l1_ydot", optional_member_value(l1, &MarginalL1Distances::ydot)});
}

std::string records_table_text(const std::vector<StudyRecord>& rows,
                               const std::vector<StudyTableColumn>& columns,
                               const report::TerminalTextFormat& format) {
  std::vector<report::TextTableColumn> filled;
  for (const auto& shown : columns) {
    filled.push_back(shown.path == "status"
                         ? report::make_status_column()
                         : report::TextTableColumn{shown.group, shown.header, shown.left_aligned,
                                                   shown.importance});
    for (const auto& row : rows) {
      const std::string cell = value_text(value_at(row, shown.path), shown.format);
      filled.back().cells.push_back(cell.empty() ? report::kMissingCell : cell);
    }
  }
  return report::format_text_table(std::move(filled), format);
}

std::string records_csv_text(const std::vector<StudyRecord>& rows, const std::string& columns) {
  std::vector<std::string> headers, paths;
  std::istringstream words(columns);
  for (std::string word; words >> word;) {
    headers.push_back(word.substr(0, word.find('=')));
    paths.push_back(word.substr(word.find('=') + 1));  // a word without '=' is both header and path
  }
  std::string lines = fmt::format("{}\n", fmt::join(headers, ","));
  for (const auto& row : rows) {
    std::vector<std::string> cells;
    for (const auto& path : paths) {
      cells.push_back(results::quote_csv_field(value_text(value_at(row, path), "{}")));
    }
    lines += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return lines;
}

std::string number_text(const std::optional<double>& number, const char* format) {
  const std::string found = value_text(transform::value_from_optional(number), format);
  return found.empty() ? report::kMissingCell : found;
}

std::string join_with_and(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (k > 0) text += k + 1 == items.size() ? " and " : ", ";
    text += items[k];
  }
  return text;
}

std::string status_reason_text(const std::string& name, const transform::Solution& solution,
                               std::size_t width) {
  if (solution.has_status_ok()) return "";
  const auto status = transform::name(solution.status);
  return report::wrap_text(fmt::format("  {} {}: {}", name, status, solution.reason), width, 4);
}

std::string study_records_to_json(
    const std::string& study, const problem::Problem& problem, const std::string& command,
    const StudyRecord& study_values,
    const std::vector<std::pair<std::string, std::vector<StudyRecord>>>& lists) {
  Json json{{"schema", results::kSummarySchema},
            {"program", results::program_to_json(results::current_program(command))},
            {"study", study}};
  json.update(results::problem_to_json(problem));
  add_record_to_json(study_values, json);
  for (const auto& [name, rows] : lists) {
    json[name] = Json::array();
    for (const auto& row : rows) add_record_to_json(row, json[name].emplace_back(Json::object()));
  }
  return results::serialise_json(results::replace_non_finite_by_null(json));
}

}  // namespace fpkcheck::study
