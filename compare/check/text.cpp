#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/check/check.hpp"
#include "compare/summary.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 40;

std::string amount(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g}", value) : kAbsent;
}

// Digits enough to see what moved.
std::string value_text(const Json& value, int digits) {
  if (value.is_null()) return kAbsent;
  return value.is_string() ? value.get<std::string>()
                           : fmt::format("{:.{}g}", value.get<double>(), digits);
}

std::pair<std::string, std::string> values(const Figure& figure) {
  constexpr int kFew = 8, kAll = 15;
  std::pair few{value_text(figure.baseline, kFew), value_text(figure.now, kFew)};
  if (few.first != few.second) return few;
  return {value_text(figure.baseline, kAll), value_text(figure.now, kAll)};
}

// How far beyond, or near, what is allowed.
double share(const Figure& figure) {
  return figure.change == 0 ? 0 : figure.change / figure.allowed;
}

std::string moved_table(const std::vector<Figure>& moved, const TextFormat& format) {
  enum { kCase, kSolution, kFigure, kBaseline, kNow, kChange, kAllowed, kUnit };
  std::vector<Column> columns{{"", "case", true, kAlwaysShown},
                              {"", "solution", true, kAlwaysShown},
                              {"", "figure", true, kAlwaysShown},
                              {"", "baseline", false, 2},
                              {"", "now", false, 2},
                              {"", "change", false, kAlwaysShown},
                              {"", "allowed", false, kAlwaysShown},
                              {"", "", true, 1}};
  for (const auto& figure : moved) {
    const bool is_number = figure.kind != FigureKind::status;
    columns[kCase].cells.push_back(figure.case_name);
    columns[kSolution].cells.push_back(figure.solution);
    columns[kFigure].cells.push_back(figure.name);
    const auto [baseline, now] = values(figure);
    columns[kBaseline].cells.push_back(baseline);
    columns[kNow].cells.push_back(now);
    columns[kChange].cells.push_back(is_number ? amount(figure.change) : kAbsent);
    columns[kAllowed].cells.push_back(is_number ? amount(figure.allowed) : kAbsent);
    columns[kUnit].cells.emplace_back(unit(figure.kind));
  }
  return rows(std::move(columns), format);
}

struct KindSummary {
  FigureKind kind;
  std::size_t count = 0;
  std::size_t moved = 0;
  std::optional<Figure> largest = {};  ///< of those that did not move
};

std::vector<KindSummary> by_kind(const Check& check) {
  std::vector<KindSummary> kinds;
  for (const auto kind : kFigureKinds) {
    KindSummary summary{kind};
    for (const auto& figure : check.figures) {
      if (figure.kind != kind) continue;
      ++summary.count;
      if (figure.moved()) {
        ++summary.moved;
      } else if (!summary.largest || share(figure) > share(*summary.largest)) {
        summary.largest = figure;
      }
    }
    if (summary.count > 0) kinds.push_back(summary);
  }
  return kinds;
}

std::string kinds_table(const Check& check, const TextFormat& format) {
  enum { kKind, kFigures, kMoved, kLargest, kAllowed, kUnit, kWhere };
  std::vector<Column> columns{{"", "compared", true, kAlwaysShown},
                              {"", "figures", false, kAlwaysShown},
                              {"", "moved", false, kAlwaysShown},
                              {"within allowance", "largest", false, kAlwaysShown},
                              {"within allowance", "allowed", false, kAlwaysShown},
                              {"within allowance", "", true, 2},
                              {"", "of", true, 1}};
  for (const auto& [kind, count, moved, largest] : by_kind(check)) {
    const bool shown = largest && kind != FigureKind::status;
    columns[kKind].cells.emplace_back(name(kind));
    columns[kFigures].cells.push_back(fmt::format("{}", count));
    columns[kMoved].cells.push_back(fmt::format("{}", moved));
    columns[kLargest].cells.push_back(shown ? amount(largest->change) : kAbsent);
    columns[kAllowed].cells.push_back(shown ? amount(largest->allowed) : kAbsent);
    columns[kUnit].cells.emplace_back(shown ? unit(kind) : "");
    columns[kWhere].cells.push_back(
        shown && largest->change > 0 ? fmt::format("{} {}", largest->case_name, largest->solution)
                                     : "");
  }
  return rows(std::move(columns), format);
}

// The clearest changes, in the order of the run.
std::vector<Figure> clearest(const std::vector<Figure>& moved, std::size_t most) {
  if (moved.size() <= most) return moved;
  std::vector<double> shares;
  for (const auto& figure : moved) shares.push_back(share(figure));
  std::ranges::nth_element(shares, shares.begin() + static_cast<std::ptrdiff_t>(most - 1),
                           std::greater<>{});
  const double least = shares[most - 1];
  std::vector<Figure> result;
  for (const auto& figure : moved) {
    if (!(share(figure) < least) && result.size() < most) result.push_back(figure);
  }
  return result;
}

Json json_of(const Figure& figure) {
  return {{"case", figure.case_name},  {"solution", figure.solution}, {"figure", figure.name},
          {"kind", name(figure.kind)}, {"baseline", figure.baseline}, {"now", figure.now},
          {"change", figure.change},   {"allowed", figure.allowed},   {"unit", unit(figure.kind)}};
}

}  // namespace

std::string check_table(const Check& check, const TextFormat& format) {
  const auto moved = check.moved();
  std::string text;
  if (!moved.empty()) {
    const auto shown = clearest(moved, kMostRows);
    text += moved_table(shown, format) + '\n';
    if (shown.size() < moved.size()) {
      text += fmt::format("and {} more (--json or --out have them all)\n\n",
                          moved.size() - shown.size());
    }
  }
  text += kinds_table(check, format) + '\n';
  for (const auto& note : check.notes) text += wrapped(note, format.width);
  text += moved.empty() ? fmt::format("{} figures of {} solutions agree.\n", check.figures.size(),
                                      check.solutions)
                        : fmt::format("{} of {} figures of {} solutions moved.\n", moved.size(),
                                      check.figures.size(), check.solutions);
  return text;
}

Json check_json(const Check& check, const std::string& command, const std::string& baseline) {
  Json kinds = Json::array(), moved = Json::array();
  for (const auto& [kind, count, moved_count, largest] : by_kind(check)) {
    kinds.push_back({{"kind", name(kind)},
                     {"figures", count},
                     {"moved", moved_count},
                     {"largest_allowed", largest ? json_of(*largest) : Json()}});
  }
  for (const auto& figure : check.moved()) moved.push_back(json_of(figure));
  return with_null_for_non_finite({{"schema", kSummarySchema},
                                   {"program", program_json(command)},
                                   {"baseline", baseline},
                                   {"tolerance", check.tolerances.deterministic},
                                   {"standard_errors", check.tolerances.standard_errors},
                                   {"solutions", check.solutions},
                                   {"figures", check.figures.size()},
                                   {"agrees", check.agrees()},
                                   {"moved", moved},
                                   {"kinds", kinds},
                                   {"notes", check.notes}});
}

}  // namespace fpkcheck::compare
