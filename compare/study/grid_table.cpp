#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compare/study/grid.hpp"
#include "compare/summary_view.hpp"
#include "compare/table.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : kAbsent;
}

std::string number_text(const Json& object, const char* key, const char* format) {
  return text_of(number(object, key), format);
}

std::string milliseconds(const Json& row) {
  const auto seconds = number(row, "seconds");
  return seconds ? fmt::format("{:.{}f}", *seconds * 1000, *seconds < 0.01 ? 1 : 0) : kAbsent;
}

template <std::size_t n>
void add_row(std::vector<Column>& all, const std::string (&cells)[n]) {
  for (std::size_t c = 0; c < n; ++c) all[c].cells.push_back(cells[c]);
}

std::string grids(const Json& report, const TextFormat& format) {
  std::vector<Column> all{{"", "order", false, kAlwaysShown},
                          {"", "cells", false, kAlwaysShown},
                          status_column(),
                          {"L1 to the limit", "p(y)", false, kAlwaysShown},
                          {"L1 to the limit", "p(y')", false, kAlwaysShown},
                          {"observed order", "L1", false, kAlwaysShown},
                          {"observed order", "E[y^2]", false, 1},
                          {"observed order", "E[y'^2]", false, 1},
                          {"", "ms", false, kAlwaysShown}};
  for (const auto& row : report.at("rows")) {
    const Json& observed = row.at("observed_order");
    const std::string cells[] = {
        fmt::format("{}", row.at("order").get<int>()),
        fmt::format("{} x {}", row.at("nx").get<int>(), row.at("nv").get<int>()),
        row.at("status").get<std::string>(),
        number_text(row, "l1_y", "{:.1e}"),
        number_text(row, "l1_ydot", "{:.1e}"),
        number_text(observed, "l1", "{:.1f}"),
        number_text(observed, "y2", "{:.1f}"),
        number_text(observed, "v2", "{:.1f}"),
        milliseconds(row)};
    add_row(all, cells);
  }
  return rows(std::move(all), format);
}

std::string limits(const Json& report, const TextFormat& format) {
  std::vector<Column> all{
      {"Richardson limit", "order", false, kAlwaysShown},
      {"Richardson limit", "E[y^2]", false, kAlwaysShown},
      {"Richardson limit", "+-", false, 1},
      {"Richardson limit", "E[y'^2]", false, kAlwaysShown},
      {"Richardson limit", "+-", false, 1},
      {"Richardson limit", "E[y^4]", false, 2},
      {"Richardson limit", "E[y'^4]", false, 2},
      {"L1 to the limit", "p(y)", false, kAlwaysShown},
      {"L1 to the limit", "p(y')", false, kAlwaysShown},
  };
  for (const auto& limit : report.at("limits")) {
    const std::string cells[] = {fmt::format("{}", limit.at("order").get<int>()),
                                 number_text(limit, "y2", "{:.8g}"),
                                 number_text(limit, "y2_error", "{:.0e}"),
                                 number_text(limit, "v2", "{:.8g}"),
                                 number_text(limit, "v2_error", "{:.0e}"),
                                 number_text(limit, "y4", "{:.7g}"),
                                 number_text(limit, "v4", "{:.7g}"),
                                 number_text(limit, "l1_y", "{:.1e}"),
                                 number_text(limit, "l1_ydot", "{:.1e}")};
    add_row(all, cells);
  }
  return rows(std::move(all), format);
}

std::string others(const Json& report, const TextFormat& format) {
  if (report.at("others").empty()) return "";
  std::vector<Column> all{{"", "other methods", true, kAlwaysShown},
                          status_column(),
                          {"L1 to the limit", "p(y)", false, kAlwaysShown},
                          {"L1 to the limit", "p(y')", false, kAlwaysShown},
                          {"", "ms", false, kAlwaysShown}};
  for (const auto& row : report.at("others")) {
    const std::string cells[] = {row.at("id").get<std::string>(),
                                 row.at("status").get<std::string>(),
                                 number_text(row, "l1_y", "{:.1e}"),
                                 number_text(row, "l1_ydot", "{:.1e}"), milliseconds(row)};
    add_row(all, cells);
  }
  return '\n' + rows(std::move(all), format);
}

std::string reasons(const Json& report, std::size_t width) {
  std::string text;
  for (const auto& row : report.at("rows")) {
    if (is_ok(row)) continue;
    text += wrapped(
        fmt::format("  order {} on {} x {} cells {}: {}", row.at("order").get<int>(),
                    row.at("nx").get<int>(), row.at("nv").get<int>(),
                    row.at("status").get<std::string>(), row.at("reason").get<std::string>()),
        width, 4);
  }
  for (const auto& row : report.at("others")) {
    if (is_ok(row)) continue;
    text += wrapped(
        fmt::format("  {} {}: {}", row.at("id").get<std::string>(),
                    row.at("status").get<std::string>(), row.at("reason").get<std::string>()),
        width, 4);
  }
  return text;
}

/// One way to a density: its cost and its error.
struct Way {
  std::string name;
  double error;
  double seconds;
};

std::optional<Way> way(const Json& row, std::string name) {
  const auto y = number(row, "l1_y"), ydot = number(row, "l1_ydot"), s = number(row, "seconds");
  if (!is_ok(row) || !y || !ydot || !s) return std::nullopt;
  return Way{std::move(name), std::max(*y, *ydot), *s};
}

// Every method named once, by the cheapest of its ways that meets the accuracy.
void keep_quickest(std::optional<Way>& best, const std::optional<Way>& candidate, double accuracy) {
  if (!candidate || candidate->error > accuracy) return;
  if (!best || candidate->seconds < best->seconds) best = candidate;
}

std::string quickest_sentence(const Json& report, double accuracy) {
  std::optional<Way> grid, closure, simulation;
  for (const auto& row : report.at("rows")) {
    keep_quickest(grid,
                  way(row, fmt::format("finite differences of order {} on {} x {} cells",
                                       row.at("order").get<int>(), row.at("nx").get<int>(),
                                       row.at("nv").get<int>())),
                  accuracy);
  }
  for (const auto& row : report.at("others")) {
    auto& best = row.at("method") == "mcs" ? simulation : closure;
    keep_quickest(best, way(row, row.at("id").get<std::string>()), accuracy);
  }
  std::vector<Way> ways;
  for (const auto& found : {grid, closure, simulation}) {
    if (found) ways.push_back(*found);
  }
  if (ways.empty()) return "";
  std::ranges::sort(ways, {}, &Way::seconds);
  std::vector<std::string> parts;
  for (const auto& w : ways) {
    parts.push_back(
        fmt::format("{} in {:.{}f} ms", w.name, w.seconds * 1000, w.seconds < 0.01 ? 1 : 0));
  }
  return fmt::format("Quickest to L1 {:.0e} in both marginals: {}.", accuracy,
                     fmt::join(parts, "; "));
}

std::string title(const Json& report) {
  return fmt::format("{}; finite differences of {}, impact {}", case_title(report),
                     report.at("equation").get<std::string>(),
                     report.at("impact").get<std::string>());
}

std::string truth_sentence(const Json& report) {
  const Json& truth = report.at("truth");
  if (truth.at("order").is_null()) {
    return fmt::format("There is no limit at the highest order: {}.",
                       truth.at("reason").get<std::string>());
  }
  const auto y = number(truth.at("known_to"), "y"), ydot = number(truth.at("known_to"), "ydot");
  std::string text = fmt::format("The limit is that of order {}", truth.at("order").get<int>());
  if (y && ydot) {
    text += fmt::format(
        "; that of the next lower order differs by L1 {:.1e} in p(y) and {:.1e} in p(y'), so "
        "smaller distances mean nothing",
        *y, *ydot);
  }
  return text + '.';
}

constexpr const char* kLegend =
    "order: of the transport terms; cells: in y and y' (narrower by sqrt 2 from level to level). L1: integral of "
    "|p - limit|. observed order: from the differences of the last three levels. +-: what the extrapolation added. "
    "ms: wall-clock time of one solve, grids by the null vector alone, one processor; the simulation on all.";

}  // namespace

std::string grid_table(const Json& report, const TextFormat& format) {
  std::string text = wrapped(title(report), format.width, 2) + grids(report, format) + '\n' +
                     limits(report, format) + others(report, format) +
                     reasons(report, format.width) +
                     wrapped("  " + truth_sentence(report), format.width, 2);
  for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const auto sentence = quickest_sentence(report, accuracy);
    if (!sentence.empty()) text += wrapped("  " + sentence, format.width, 2);
  }
  return text + '\n' + wrapped(kLegend, format.width);
}

}  // namespace fpkcheck::compare
