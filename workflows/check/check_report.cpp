#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"
#include "results/run_json.hpp"
#include "workflows/check/compare_runs.hpp"

namespace fpkcheck::check {
namespace {

using base::Value;
using report::kAlwaysShown;
using report::kMissingCell;
using report::TerminalTextFormat;
using report::TextTableColumn;
using results::Json;

Json quantity_change_json(const CheckedQuantityChange& quantity_change) {
  return {{"case", quantity_change.case_name},
          {"solution", quantity_change.solution},
          {"figure", quantity_change.name},
          {"kind", name(quantity_change.kind)},
          {"baseline", results::value_to_json(quantity_change.baseline)},
          {"now", results::value_to_json(quantity_change.now)},
          {"change", quantity_change.change},
          {"allowed", quantity_change.allowed},
          {"unit", unit_of_change(quantity_change.kind)}};
}

constexpr std::size_t kMaxRows = 40;

std::string change_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g}", value) : kMissingCell;
}

std::string parameter_value_text(const Value& value, int digits) {
  if (base::is_unset(value)) return kMissingCell;
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:.{}g}", *number, digits) : base::value_as_text(value);
}

// Returns the texts of two compared values, with few digits, or with all digits if few digits would
// not show the change.
std::pair<std::string, std::string> value_texts(const CheckedQuantityChange& quantity_change) {
  constexpr int kFewDigits = 8, kAllDigits = 15;
  std::pair few{parameter_value_text(quantity_change.baseline, kFewDigits),
                parameter_value_text(quantity_change.now, kFewDigits)};
  if (few.first != few.second) return few;
  return {parameter_value_text(quantity_change.baseline, kAllDigits),
          parameter_value_text(quantity_change.now, kAllDigits)};
}

std::string changed_quantity_table(const std::vector<CheckedQuantityChange>& moved,
                                   const TerminalTextFormat& format) {
  std::vector<TextTableColumn> columns{{"", "case", true, kAlwaysShown},
                                       {"", "solution", true, kAlwaysShown},
                                       {"", "figure", true, kAlwaysShown},
                                       {"", "baseline", false, 2},
                                       {"", "now", false, 2},
                                       {"", "change", false, kAlwaysShown},
                                       {"", "allowed", false, kAlwaysShown},
                                       {"", "", true, 1}};
  for (const CheckedQuantityChange& f : moved) {
    const bool is_number = f.kind != CheckedQuantityKind::status;
    const auto [baseline, now] = value_texts(f);
    report::add_table_row(columns, {f.case_name, f.solution, f.name, baseline, now,
                                    is_number ? change_text(f.change) : kMissingCell,
                                    is_number ? change_text(f.allowed) : kMissingCell,
                                    std::string(unit_of_change(f.kind))});
  }
  return report::format_text_table(std::move(columns), format);
}

std::string quantity_kind_table(const BaselineCheckResult& check,
                                const TerminalTextFormat& format) {
  std::vector<TextTableColumn> columns{{"", "compared", true, kAlwaysShown},
                                       {"", "figures", false, kAlwaysShown},
                                       {"", "moved", false, kAlwaysShown},
                                       {"within allowance", "largest", false, kAlwaysShown},
                                       {"within allowance", "allowed", false, kAlwaysShown},
                                       {"within allowance", "", true, 2},
                                       {"", "of", true, 1}};
  for (const auto& [kind, count, moved, largest] : summarise_changes_by_kind(check)) {
    const bool shown = largest != nullptr && kind != CheckedQuantityKind::status;
    const std::string of =
        shown && largest->change > 0 ? largest->case_name + ' ' + largest->solution : "";
    report::add_table_row(
        columns, {std::string(name(kind)), fmt::format("{}", count), fmt::format("{}", moved),
                  shown ? change_text(largest->change) : kMissingCell,
                  shown ? change_text(largest->allowed) : kMissingCell,
                  std::string(shown ? unit_of_change(kind) : ""), of});
  }
  return report::format_text_table(std::move(columns), format);
}

// Returns those changes between two runs that are largest in units of their tolerance, in the order
// of the run.
std::vector<CheckedQuantityChange> largest_changes(const std::vector<CheckedQuantityChange>& moved,
                                                   std::size_t most) {
  if (moved.size() <= most) return moved;
  std::vector<double> shares;
  for (const auto& quantity_change : moved)
    shares.push_back(quantity_change.change_divided_by_tolerance());
  std::ranges::nth_element(shares, shares.begin() + static_cast<std::ptrdiff_t>(most - 1),
                           std::greater<>{});
  const double least = shares[most - 1];
  std::vector<CheckedQuantityChange> result;
  for (const auto& quantity_change : moved) {
    if (!(quantity_change.change_divided_by_tolerance() < least) && result.size() < most)
      result.push_back(quantity_change);
  }
  return result;
}

}  // namespace

std::string check_result_json(const BaselineCheckResult& check, const std::string& command,
                              const std::string& baseline) {
  Json kinds = Json::array(), moved = Json::array();
  for (const auto& [kind, count, moved_count, largest] : summarise_changes_by_kind(check)) {
    kinds.push_back(
        {{"kind", name(kind)},
         {"figures", count},
         {"moved", moved_count},
         {"largest_allowed", largest == nullptr ? Json() : quantity_change_json(*largest)}});
  }
  for (const auto& quantity_change : check.quantities_beyond_tolerance())
    moved.push_back(quantity_change_json(quantity_change));
  return results::serialise_json(results::replace_non_finite_by_null(
      {{"schema", results::kSummarySchema},
       {"program", results::program_to_json(results::current_program(command))},
       {"baseline", baseline},
       {"tolerance", check.tolerances.deterministic},
       {"standard_errors", check.tolerances.standard_errors},
       {"solutions", check.solutions},
       {"figures", check.changes.size()},
       {"agrees", check.agrees_with_baseline()},
       {"moved", moved},
       {"kinds", kinds},
       {"notes", check.notes}}));
}

std::string check_result_table(const BaselineCheckResult& check, const TerminalTextFormat& format) {
  const auto moved = check.quantities_beyond_tolerance();
  std::string text;
  if (!moved.empty()) {
    const auto shown = largest_changes(moved, kMaxRows);
    text += changed_quantity_table(shown, format) + '\n';
    if (shown.size() < moved.size()) {
      text += fmt::format("and {} more (all of them: --json or --out)\n\n",
                          moved.size() - shown.size());
    }
  }
  text += quantity_kind_table(check, format) + '\n';
  for (const auto& note : check.notes) text += report::wrap_text(note, format.width);
  text += moved.empty() ? fmt::format("{} figures of {} solutions agree.\n", check.changes.size(),
                                      check.solutions)
                        : fmt::format("{} of {} figures of {} solutions moved.\n", moved.size(),
                                      check.changes.size(), check.solutions);
  return text;
}

}  // namespace fpkcheck::check
