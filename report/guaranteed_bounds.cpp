#include "report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "compare/solution_assessment.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/number_text.hpp"
#include "report/text/text_layout.hpp"

namespace fpkcheck::report {
namespace {

using compare::BoundViolation;
using compare::GuaranteedBound;
using compare::GuaranteedBounds;

std::string bound_text(const GuaranteedBound& bound) {
  const auto [lower, upper] = round_interval_outward(bound.lower, bound.upper);
  return fmt::format("{} in [{}, {}]", bound.functional, lower, upper);
}

std::string contradiction_text(const BoundViolation& violation) {
  const auto [lower, upper] =
      round_interval_outward(violation.bound->lower, violation.bound->upper);
  return fmt::format(
      "OUTSIDE THE BOUNDS: {} (full problem, status {}) has {} = {:.8g}, guaranteed to lie in "
      "[{}, {}]. The error is at least {:.1e}, above the stated error of {:.1e}.",
      violation.solution->id(), transform::name(violation.solution->status),
      violation.bound->functional, violation.value, lower, upper, violation.excess,
      violation.error_estimate);
}

}  // namespace

std::vector<std::string> guaranteed_bounds_findings(const results::CaseResult& case_result) {
  if (!case_result.bounds) return {};
  const GuaranteedBounds& bounds = *case_result.bounds;
  if (bounds.each.empty()) {
    return {fmt::format("There are no guaranteed bounds: {}.", bounds.reason)};
  }
  std::vector<std::string> sentences, shown, ids;
  for (const BoundViolation& violation :
       compare::violations_beyond_error_estimate(bounds, case_result.solutions)) {
    sentences.push_back(contradiction_text(violation));
  }
  for (const BoundViolation& violation : compare::bound_violations(bounds, case_result.solutions)) {
    // Violations of the guaranteed bounds by solutions of the full problem are skipped. Violations
    // of bounds above the error estimate are already reported, and violations below the error
    // estimate do not contradict the bounds.
    if (compare::is_solution_of_full_problem(*violation.solution)) continue;
    if (ids.empty() || ids.back() != violation.solution->id())
      ids.push_back(violation.solution->id());
  }
  for (const auto moment : {&transform::Moments::y2, &transform::Moments::v2}) {
    if (const GuaranteedBound* bound = compare::find_moment_bound(bounds, moment))
      shown.push_back(bound_text(*bound));
  }
  sentences.push_back(fmt::format("Guaranteed bounds: {}. Outside the bounds: {}.",
                                  fmt::join(shown, ", "),
                                  ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", "))));
  return sentences;
}

std::string guaranteed_bounds_table(const problem::Problem& problem, const GuaranteedBounds& bounds,
                                    const TerminalTextFormat& format) {
  std::string all = wrap_text(case_title(problem), format.width, 2);
  if (bounds.each.empty()) return all + wrap_text("no bounds: " + bounds.reason, format.width, 2);
  std::vector<TextTableColumn> columns{{"", "functional", true, kAlwaysShown},
                                       {"", "lower", false, kAlwaysShown},
                                       {"", "upper", false, kAlwaysShown},
                                       {"", "half-width", false, 2},
                                       {"", "relative", false, 1}};
  for (const GuaranteedBound& bound : bounds.each) {
    const auto ends = round_interval_outward(bound.lower, bound.upper);
    const double middle = std::abs(bound.lower + bound.half_width());
    add_table_row(
        columns,
        {bound.functional, ends.lower, ends.upper, fmt::format("{:.1e}", bound.half_width()),
         middle > 0 ? fmt::format("{:.1e}", bound.half_width() / middle) : kMissingCell});
  }
  all += format_text_table(std::move(columns), format);
  if (!bounds.reason.empty()) all += wrap_text(bounds.reason, format.width, 2);
  return all;
}

}  // namespace fpkcheck::report
