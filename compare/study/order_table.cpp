#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "compare/study/order.hpp"
#include "compare/summary_view.hpp"
#include "compare/table.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string number_text(const Json& row, const char* key, const char* format, double factor = 1) {
  const auto value = number(row, key);
  return value ? fmt::format(fmt::runtime(format), *value * factor) : kAbsent;
}

// What Q_n itself does at infinity, also where a confinement holds the density down.
std::string leading_form_text(const Json& row) {
  const bool confined = row.contains("tail") && row.at("tail").is_object();
  const Json& form =
      confined ? row.at("tail").at("polynomial_leading_form") : row.at("leading_form");
  if (!form.is_string()) return kAbsent;
  return form == "negative" ? "falls" : "rises";
}

std::string edge_text(const Json& row) {
  return row.at("support").is_object() ? number_text(row.at("support"), "edge_density", "{:.0e}")
                                       : kAbsent;
}

std::vector<Column> columns(const Json& report) {
  std::vector<Column> all{{"", "formulation", true, kAlwaysShown},
                          {"", "n", false, kAlwaysShown},
                          status_column(),
                          {"", "steps", false, 3},
                          {"", "cond.", false, 1},
                          {"", "residual", false, 4},
                          {"", "Q_n", true, 2},
                          {"", "edge", false, 2},
                          {"", "to n-2", false, 1},
                          {"L1 to fd-kf", "p(y)", false, kAlwaysShown},
                          {"L1 to fd-kf", "p(y')", false, kAlwaysShown},
                          {"tail", "p(y)", false, 5},
                          {"tail", "p(y')", false, 5},
                          {"", "ms", false, kAlwaysShown}};
  for (const auto& row : report.at("rows")) {
    const std::string cells[] = {row.at("formulation").get<std::string>(),
                                 fmt::format("{}", row.at("order").get<int>()),
                                 row.at("status").get<std::string>(),
                                 number_text(row, "iterations", "{:.0f}"),
                                 number_text(row, "condition", "{:.0e}"),
                                 number_text(row, "residual", "{:.0e}"),
                                 leading_form_text(row),
                                 edge_text(row),
                                 number_text(row, "distance_to_previous", "{:.5f}"),
                                 number_text(row, "l1_y", "{:.5f}"),
                                 number_text(row, "l1_ydot", "{:.5f}"),
                                 number_text(row, "tail_y", "{:.2f}"),
                                 number_text(row, "tail_ydot", "{:.2f}"),
                                 number_text(row, "seconds", "{:.0f}", 1000)};
    for (std::size_t c = 0; c < all.size(); ++c) all[c].cells.push_back(cells[c]);
  }
  return all;
}

std::string reasons(const Json& report, std::size_t width) {
  std::string text;
  for (const auto& row : report.at("rows")) {
    if (is_ok(row)) continue;
    text += wrapped(fmt::format("  {} n = {} {}: {}", row.at("formulation").get<std::string>(),
                                row.at("order").get<int>(), row.at("status").get<std::string>(),
                                row.at("reason").get<std::string>()),
                    width, 4);
  }
  const Json& reference = report.at("reference");
  if (!is_ok(reference)) {
    text +=
        wrapped(fmt::format("  The reference {} is {}: {}", reference.at("id").get<std::string>(),
                            reference.at("status").get<std::string>(),
                            reference.at("reason").get<std::string>()),
                width, 4);
  }
  return text;
}

std::string end_of(const Json& branch) {
  const auto end = branch.at("end").get<std::string>();
  if (end == "full_problem") return "arrives at the full problem";
  if (end == "white_noise") return "comes back to white noise at another root";
  if (end == "far_away") return "leaves with coefficients beyond all measure";
  return "is lost";
}

// Where the branch from the exact density turns round.
std::string branch_sentence(const Json& row) {
  std::string folds;
  for (const auto& point : row.at("branch").at("points")) {
    if (!point.at("fold").get<bool>()) continue;
    folds += fmt::format("{}{:.1f} %", folds.empty() ? "" : ", ",
                         100 * point.at("fraction").get<double>());
  }
  return fmt::format(
      "{} n = {}: the branch of solutions from the exact density of white noise without impact "
      "losses {}, gets as far as {:.1f} % of the way, and {}.",
      row.at("formulation").get<std::string>(), row.at("order").get<int>(),
      folds.empty() ? "has no fold" : "folds at " + folds,
      100 * row.at("branch").at("furthest").get<double>(), end_of(row.at("branch")));
}

// By how much each two orders more bring a formulation nearer, on average: a closure that
// converges does so geometrically, so that an exponent of n would say nothing.
std::string fall_sentence(const Json& first, const Json& last) {
  const double steps = (last.at("order").get<int>() - first.at("order").get<int>()) / 2.0;
  const auto factor = [&](const char* key) {
    return std::pow(*number(first, key) / *number(last, key), 1 / steps);
  };
  return fmt::format(" On average n + 2 divides it by {:.1f} and {:.1f}.", factor("l1_y"),
                     factor("l1_ydot"));
}

// What a formulation's orders are worth: its rows that are ok.
std::string convergence_sentence(const std::string& formulation,
                                 const std::vector<const Json*>& rows) {
  std::vector<const Json*> good;
  for (const Json* row : rows) {
    if (is_ok(*row) && number(*row, "l1_y") && number(*row, "l1_ydot")) good.push_back(row);
  }
  if (good.empty()) return fmt::format("{}: no order gives a density.", formulation);
  std::string orders;
  for (std::size_t k = 0; k < good.size(); ++k) {
    orders += fmt::format("{}{}",
                          k == 0                 ? ""
                          : k + 1 == good.size() ? " and "
                                                 : ", ",
                          good[k]->at("order").get<int>());
  }
  const Json &first = *good.front(), &last = *good.back();
  std::string text = fmt::format("{} is ok at n = {}", formulation, orders);
  if (good.size() == 1) {
    return text + fmt::format(": L1 {:.2g} in p(y), {:.2g} in p(y').", *number(first, "l1_y"),
                              *number(first, "l1_ydot"));
  }
  return text +
         fmt::format(
             "; from n = {} to {} the L1 distance goes from {:.2g} to {:.2g} in p(y) "
             "and from {:.2g} to {:.2g} in p(y').",
             first.at("order").get<int>(), last.at("order").get<int>(), *number(first, "l1_y"),
             *number(last, "l1_y"), *number(first, "l1_ydot"), *number(last, "l1_ydot")) +
         fall_sentence(first, last);
}

constexpr const char* kLegend =
    "steps: of Newton's method, all orders and attempts together. cond.: condition of Newton's matrix in "
    "scaled functions. residual: largest equation relative to the damping c. Q_n: falls in every "
    "direction in the end, or rises in some. edge: largest density on the edge of the support "
    "relative to the peak. to n-2: L1 distance of both marginals to those of order n-2, together. L1: integral of |p - reference|. tail: mean |log10 p - log10 reference| "
    "over reference densities 1e-5 .. 1e-4. ms: wall-clock time.";

}  // namespace

std::string order_table(const Json& report, const TextFormat& format) {
  std::string text = wrapped(case_title(report), format.width, 2) + rows(columns(report), format) +
                     reasons(report, format.width);
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Json*>> by_formulation;
  for (const auto& row : report.at("rows")) {
    const auto formulation = row.at("formulation").get<std::string>();
    if (!by_formulation.contains(formulation)) order.push_back(formulation);
    by_formulation[formulation].push_back(&row);
    if (row.contains("branch") && row.at("branch").is_object()) {
      text += wrapped("  " + branch_sentence(row), format.width, 4);
    }
  }
  for (const auto& formulation : order) {
    text += wrapped("  " + convergence_sentence(formulation, by_formulation[formulation]),
                    format.width, 2);
  }
  return text + '\n' + wrapped(kLegend, format.width);
}

}  // namespace fpkcheck::compare
