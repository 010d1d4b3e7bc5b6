#include "compare/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "compare/findings.hpp"
#include "compare/summary_view.hpp"
#include "compare/wrapped_text.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

struct Column {
  std::string group;  ///< stands over neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< columns of equal importance come and go together
  std::vector<std::string> cells = {};

  std::size_t width() const {
    std::size_t width = header.size();
    for (const auto& cell : cells) width = std::max(width, cell.size());
    return width;
  }
};

constexpr int kAlwaysShown = std::numeric_limits<int>::max();
constexpr const char* kAbsent = "-";

std::string shown(const std::optional<double>& value,
                  const std::function<std::string(double)>& format) {
  return value ? format(*value) : kAbsent;
}

std::string moment_text(double x) { return fmt::format("{:#.4g}", x); }

std::string l1_text(double x) {
  constexpr double kSmallestShown = 1e-5;
  if (x == 0) return "0";
  return x < kSmallestShown ? fmt::format("{:.0e}", x) : fmt::format("{:.5f}", x);
}

std::string energy_text(double x) { return x == 0 ? "0" : fmt::format("{:.0e}", x); }

std::string seconds_text(double x) {
  return fmt::format("{:.{}f}", x, x < 10 ? 2 : x < 100 ? 1 : 0);
}

std::vector<Column> columns(const Json& summary_case) {
  std::vector<Column> all{{"", "solution", true, kAlwaysShown},
                          {"", "solves", true, 4},
                          {"", "status", true, kAlwaysShown},
                          {"", "E[y^2]", false, 5},
                          {"", "E[y'^2]", false, 5},
                          {"L1 to mcs", "p(y)", false, kAlwaysShown},
                          {"L1 to mcs", "p(y')", false, kAlwaysShown},
                          {"L1 to fd-kf", "p(y)", false, 2},
                          {"L1 to fd-kf", "p(y')", false, 2},
                          {"", "energy", false, 1},
                          {"", "sec", false, 3}};
  for (const auto& solution : summary_case.at("solutions")) {
    const auto id = solution.at("id").get<std::string>();
    const Json& moments = solution.at("moments");
    const auto l1 = [&](const char* reference, Variable variable) {
      return shown(l1_between(summary_case, id, reference, variable), l1_text);
    };
    const std::string cells[] = {id,
                                 fmt::format("{}/{}", solution.at("equation").get<std::string>(),
                                             solution.at("impact").get<std::string>()),
                                 solution.at("status").get<std::string>(),
                                 shown(number(moments, "y2"), moment_text),
                                 shown(number(moments, "v2"), moment_text),
                                 l1("mcs", Variable::y),
                                 l1("mcs", Variable::ydot),
                                 l1("fd-kf", Variable::y),
                                 l1("fd-kf", Variable::ydot),
                                 shown(number(solution, "energy_residual"), energy_text),
                                 shown(number(solution, "seconds"), seconds_text)};
    for (std::size_t c = 0; c < all.size(); ++c) all[c].cells.push_back(cells[c]);
  }
  // A column without a value, as the distances to a simulation that was not run, says nothing.
  std::erase_if(all, [](const Column& column) {
    return std::ranges::all_of(column.cells, [](const auto& cell) { return cell == kAbsent; });
  });
  return all;
}

std::size_t total_width(const std::vector<Column>& shown_columns, std::size_t gap) {
  std::size_t total = 0;
  for (const auto& column : shown_columns) total += column.width() + gap;
  return total - std::min(total, gap);
}

void drop_until_it_fits(std::vector<Column>& all, std::size_t width) {
  while (total_width(all, 1) > width) {
    const int least = std::ranges::min_element(all, {}, &Column::importance)->importance;
    if (least == kAlwaysShown) return;
    std::erase_if(all, [&](const Column& column) { return column.importance == least; });
  }
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string group_line(const std::vector<Column>& all, const std::string& gap) {
  std::string line;
  for (std::size_t c = 0; c < all.size();) {
    std::size_t span = all[c].width(), next = c + 1;
    for (; next < all.size() && !all[c].group.empty() && all[next].group == all[c].group; ++next) {
      span += gap.size() + all[next].width();
    }
    const std::string text = all[c].group.empty() ? "" : ' ' + all[c].group + ' ';
    line += fmt::format(fmt::runtime(text.empty() ? "{: ^{}}" : "{:-^{}}"), text, span) + gap;
    c = next;
  }
  return without_trailing_spaces(line);
}

std::string row(const std::vector<Column>& all, const std::string& gap,
                const std::function<const std::string&(const Column&)>& text_of) {
  std::string line;
  for (const auto& column : all) {
    line += column.left_aligned ? fmt::format("{:<{}}", text_of(column), column.width())
                                : fmt::format("{:>{}}", text_of(column), column.width());
    line += gap;
  }
  return without_trailing_spaces(line);
}

std::string rows(const Json& summary_case, std::size_t width) {
  auto all = columns(summary_case);
  drop_until_it_fits(all, width);
  const std::string gap(total_width(all, 2) <= width ? 2 : 1, ' ');
  std::string text = group_line(all, gap);
  text += row(all, gap, [](const Column& c) -> const std::string& { return c.header; });
  for (std::size_t k = 0; k < summary_case.at("solutions").size(); ++k) {
    text += row(all, gap, [k](const Column& c) -> const std::string& { return c.cells[k]; });
  }
  return text;
}

std::string title(const Json& summary_case) {
  const Json& system = summary_case.at("system");
  const Json& impulse = summary_case.at("impulse");
  std::string text = fmt::format(
      "{}: c = {:g}, k = {:g}, mu = {:g}, r = {:g}; {} impulses, lambda = {:g}, lambda E[Y^2] = "
      "{:g}",
      summary_case.at("name").get<std::string>(), system.at("damping").get<double>(),
      system.at("stiffness").get<double>(), system.at("cubic").get<double>(),
      system.at("restitution").get<double>(), impulse.at("law").get<std::string>(),
      impulse.at("rate").get<double>(), impulse.at("intensity").get<double>());
  const double mean = impulse.at("mean").get<double>();
  if (mean != 0) text += fmt::format(", E[Y] = {:g}", mean);
  return text;
}

std::string reasons(const Json& summary_case, std::size_t width) {
  std::string text;
  for (const auto& solution : summary_case.at("solutions")) {
    if (is_ok(solution)) continue;
    text += wrapped(fmt::format("  {} {}: {}", solution.at("id").get<std::string>(),
                                solution.at("status").get<std::string>(),
                                solution.at("reason").get<std::string>()),
                    width, 4);
  }
  return text;
}

constexpr const char* kLegend =
    "L1: integral of |p - reference|, 0 for equal densities, 2 for disjoint ones. solves: the "
    "excitation term (white: white noise; km4: Kramers-Moyal series to the fourth derivative; "
    "kf: full jump integral) / the impact. energy: residual of the power balance relative to the "
    "input.";

}  // namespace

std::string table(const Json& summary, std::size_t width) {
  std::string text;
  for (const auto& summary_case : summary.at("cases")) {
    text += wrapped(title(summary_case), width, 2) + rows(summary_case, width) +
            reasons(summary_case, width);
    for (const auto& sentence : findings(summary_case)) {
      text += wrapped("  " + sentence, width, 2);
    }
    text += '\n';
  }
  return text + wrapped(kLegend, width);
}

}  // namespace fpkcheck::compare
