#include "compare/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

#include "compare/budget/table.hpp"
#include "compare/findings.hpp"
#include "compare/legend.hpp"
#include "compare/summary_view.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/l1_text.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

std::string shown(const std::optional<double>& value,
                  const std::function<std::string(double)>& format) {
  return value ? format(*value) : kAbsent;
}

std::string moment_text(double x) { return fmt::format("{:#.4g}", x); }

std::string energy_text(double x) { return x == 0 ? "0" : fmt::format("{:.0e}", x); }

std::string seconds_text(double x) {
  return fmt::format("{:.{}f}", x, x < 10 ? 2 : x < 100 ? 1 : 0);
}

std::vector<Column> columns(const Json& summary_case) {
  std::vector<Column> all{{"", "solution", true, kAlwaysShown},
                          {"", "solves", true, 4},
                          status_column(),
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

void append(std::vector<Column>& all, std::vector<Column> more) {
  all.insert(all.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

}  // namespace

std::string case_title(const Json& summary_case) {
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

std::string table(const Json& summary, const TextFormat& format) {
  const std::size_t width = format.width;
  std::string text;
  std::vector<Column> results, budgets;
  for (const auto& summary_case : summary.at("cases")) {
    const auto shown = fitting(columns(summary_case), format);
    text += wrapped(case_title(summary_case), width, 2) + rows(shown, format) +
            reasons(summary_case, width) + budget_table(summary_case, format);
    for (const auto& sentence : findings(summary_case)) {
      text += wrapped("  " + sentence, width, 2);
    }
    text += '\n';
    append(results, shown);
    append(budgets, budget_columns(summary_case, format));
  }
  for (const auto& legend : {results_legend(results), budget_legend(budgets)}) {
    if (!legend.empty()) text += wrapped(legend, width);
  }
  return text;
}

}  // namespace fpkcheck::compare
