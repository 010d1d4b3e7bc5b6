#include "report/bounds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compare/reference.hpp"
#include "report/table.hpp"
#include "report/text/columns.hpp"
#include "report/text/outward.hpp"
#include "report/text/wrapped.hpp"

namespace fpkcheck::report {
namespace {

using compare::Bound;
using compare::Bounds;
using compare::Outside;

std::string text(const Bound& bound) {
  const auto [lower, upper] = outward(bound.lower, bound.upper);
  return fmt::format("{} in [{}, {}]", bound.functional, lower, upper);
}

std::string contradiction(const Outside& found) {
  const auto [lower, upper] = outward(found.bound->lower, found.bound->upper);
  return fmt::format(
      "OUTSIDE THE BOUNDS: {} (full problem, status {}) has {} = {:.8g}, guaranteed to lie in "
      "[{}, {}]. The error is at least {:.1e}, above the stated error of {:.1e}.",
      found.solution->id(), transform::name(found.solution->status), found.bound->functional,
      found.value, lower, upper, found.by, found.own_error);
}

}  // namespace

std::vector<std::string> bounds_findings(const results::Case& one) {
  if (!one.bounds) return {};
  const Bounds& bounds = *one.bounds;
  if (bounds.each.empty()) {
    return {fmt::format("There are no guaranteed bounds: {}.", bounds.reason)};
  }
  std::vector<std::string> sentences, shown, ids;
  for (const Outside& found : compare::contradictions(bounds, one.solutions)) {
    sentences.push_back(contradiction(found));
  }
  for (const Outside& found : compare::outside(bounds, one.solutions)) {
    // Here a solution of the full problem is outside by no more than its stated error: consistent.
    if (compare::solves_the_problem(*found.solution)) continue;
    if (ids.empty() || ids.back() != found.solution->id()) ids.push_back(found.solution->id());
  }
  for (const auto moment : {&transform::Moments::y2, &transform::Moments::v2}) {
    if (const Bound* bound = compare::bound_of(bounds, moment)) shown.push_back(text(*bound));
  }
  sentences.push_back(fmt::format("Guaranteed bounds: {}. Outside the bounds: {}.",
                                  fmt::join(shown, ", "),
                                  ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", "))));
  return sentences;
}

std::string bounds_table(const problem::Problem& problem, const Bounds& bounds,
                         const TextFormat& format) {
  std::string all = wrapped(case_title(problem), format.width, 2);
  if (bounds.each.empty()) return all + wrapped("no bounds: " + bounds.reason, format.width, 2);
  Column functional{"", "functional", true, kAlwaysShown}, lower{"", "lower", false, kAlwaysShown},
      upper{"", "upper", false, kAlwaysShown}, half{"", "half-width", false, 2},
      relative{"", "relative", false, 1};
  for (const Bound& bound : bounds.each) {
    const auto ends = outward(bound.lower, bound.upper);
    const double middle = std::abs(bound.lower + bound.half_width());
    functional.cells.push_back(bound.functional);
    lower.cells.push_back(ends.lower);
    upper.cells.push_back(ends.upper);
    half.cells.push_back(fmt::format("{:.1e}", bound.half_width()));
    relative.cells.push_back(middle > 0 ? fmt::format("{:.1e}", bound.half_width() / middle)
                                        : kAbsent);
  }
  all += rows({functional, lower, upper, half, relative}, format);
  if (!bounds.reason.empty()) all += wrapped(bounds.reason, format.width, 2);
  return all;
}

}  // namespace fpkcheck::report
