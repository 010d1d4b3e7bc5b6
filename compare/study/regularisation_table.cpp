#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "compare/study/regularisation.hpp"
#include "compare/summary_view.hpp"
#include "compare/table.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string number_text(const Json& row, const char* key, const char* format) {
  const auto value = number(row, key);
  return value ? fmt::format(fmt::runtime(format), *value) : kAbsent;
}

bool grows(const Json& row) { return number(row, "growth_rate").has_value(); }

bool symbol_grows(const Json& row) {
  return row.at("symbol_grows").is_boolean() && row.at("symbol_grows").get<bool>();
}

// The symbol's rate tends to 0 for long waves when none grows.
std::string symbol_text(const Json& row, const char* key) {
  if (row.at("symbol_rate").is_null()) return kAbsent;
  if (symbol_grows(row)) return number_text(row, key, "{:.4g}");
  return key == std::string("symbol_rate") ? "0" : kAbsent;
}

std::string eigenvalue_text(const Json& row, const char* key) {
  const Json& value = row.at(key);
  if (value.is_null()) return kAbsent;
  const double re = *number(value, "re"), im = *number(value, "im");
  const std::string real =
      std::abs(re) < 1e-7 ? fmt::format("{:.0e}", re) : fmt::format("{:.4g}", re);
  return std::abs(im) > 1e-7 ? fmt::format("{}+-{:.3g}i", real, im) : real;
}

std::string fate_text(const Json& row) {
  if (const auto rate = number(row, "growth_rate")) {
    return fmt::format("x10 in {:.2g}", std::numbers::ln10 / *rate);
  }
  if (!row.at("rightmost").is_null()) return "settles";
  return row.at("symbol_rate").is_null() ? kAbsent : "no growth";
}

std::string l1_text(const Json& row, const char* key) {
  const auto value = number(row, key);
  if (!value) return kAbsent;
  return *value < 10 ? fmt::format("{:.5f}", *value) : fmt::format("{:.1e}", *value);
}

std::vector<Column> columns(const Json& report) {
  std::vector<Column> all{{"", "scheme", true, kAlwaysShown},
                          {"", "h", false, kAlwaysShown},
                          {"", "l", false, 4},
                          {"", "cells", false, 1},
                          {"symbol", "rate", false, kAlwaysShown},
                          {"symbol", "q", false, kAlwaysShown},
                          {"matrix", "rightmost", false, kAlwaysShown},
                          {"matrix", "next", false, 2},
                          {"", "in time", true, kAlwaysShown},
                          {"null vector", "L1 p(y)", false, 3},
                          {"null vector", "L1 p(y')", false, kAlwaysShown},
                          {"null vector", "least", false, kAlwaysShown}};
  for (const auto& row : report.at("rows")) {
    const std::string cells[] = {
        row.at("scheme").get<std::string>(),
        number_text(row, "step", "{:.3g}"),
        number_text(row, "length", "{:.3g}"),
        fmt::format("{}x{}", row.at("nx").get<int>(), row.at("nv").get<int>()),
        symbol_text(row, "symbol_rate"),
        symbol_text(row, "symbol_wavenumber"),
        eigenvalue_text(row, "rightmost"),
        eigenvalue_text(row, "next"),
        fate_text(row),
        l1_text(row, "l1_y"),
        l1_text(row, "l1_ydot"),
        number_text(row, "min_density", "{:.0e}")};
    for (std::size_t c = 0; c < all.size(); ++c) all[c].cells.push_back(cells[c]);
  }
  return all;
}

// "h = 0.158, 0.0791 and 0.0395"
std::string list_of_steps(const std::vector<const Json*>& rows) {
  std::string text = "h = ";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0) text += k + 1 == rows.size() ? " and " : ", ";
    text += number_text(*rows[k], "step", "{:.3g}");
  }
  return text;
}

std::vector<const Json*> rows_of(const Json& report, const std::string& scheme, bool growing) {
  std::vector<const Json*> rows;
  for (const auto& row : report.at("rows")) {
    const bool known = !row.at("symbol_rate").is_null();
    if (row.at("scheme") == scheme && known && grows(row) == growing) rows.push_back(&row);
  }
  return rows;
}

// The exponent of h in the growth between the two finest steps that grow.
std::string literal_sentence(const Json& report) {
  const auto growing = rows_of(report, "literal", true);
  if (growing.empty()) return "The literal scheme grows on none of these steps.";
  std::string text = fmt::format("The literal scheme, l = h, grows at {}", list_of_steps(growing));
  if (growing.size() > 1) {
    const Json &fine = *growing.back(), &coarse = *growing[growing.size() - 2];
    const double exponent =
        std::log(*number(fine, "growth_rate") / *number(coarse, "growth_rate")) /
        std::log(*number(fine, "step") / *number(coarse, "step"));
    text += fmt::format(", in the end as h^{:.2f} (h^-4 in the limit)", exponent);
  }
  double farthest = 0;
  std::optional<double> lowest;
  for (const Json* row : growing) {
    farthest = std::max(farthest, number(*row, "l1_ydot").value_or(0));
    if (const auto least = number(*row, "min_density"))
      lowest = std::min(lowest.value_or(*least), *least);
  }
  text += ": no refinement can converge.";
  if (lowest) {
    text += fmt::format(
        " Its null vector is then up to L1 {:.2g} from kf and falls to {:.2g} of its peak.",
        farthest, *lowest);
  }
  return text;
}

std::string regularised_sentence(const Json& report) {
  const auto growing = rows_of(report, "regularised", true);
  const auto settled = rows_of(report, "regularised", false);
  std::string text = fmt::format("The fourth difference over the default length l = {:.3g}",
                                 *number(report, "default_length"));
  if (settled.empty()) return text + " grows on every step.";
  text += growing.empty() ? " grows on no step"
                          : fmt::format(" grows at {} and not at {}", list_of_steps(growing),
                                        list_of_steps(settled));
  const Json& finest = *settled.back();
  if (number(finest, "l1_y") && number(finest, "l1_ydot")) {
    text += fmt::format(
        "; on the finest of them its density is L1 {:.2g} in p(y) and {:.2g} in p(y') from kf",
        *number(finest, "l1_y"), *number(finest, "l1_ydot"));
  }
  return text + '.';
}

std::string threshold_sentence(const Json& report) {
  const auto below = rows_of(report, "0.9 l*", true), above = rows_of(report, "1.1 l*", true);
  std::string text =
      fmt::format("The threshold is l* = {:.3g}: ", *number(report, "shortest_length"));
  text += below.empty() ? "10 % below it no matrix grows"
                        : fmt::format("10 % below it grow {}", list_of_steps(below));
  if (below.size() > 1) {
    const auto rate = number(*below.back(), "symbol_rate");
    text += fmt::format(", at a rate that no longer depends on the step ({:.3g} by the symbol)",
                        rate.value_or(0));
  }
  text += above.empty() ? "; 10 % above it none grows."
                        : fmt::format("; 10 % above it grow {}.", list_of_steps(above));
  return text;
}

std::string remarks(const Json& report, std::size_t width) {
  std::map<std::string, std::string> rows_with;  // remark -> rows
  std::vector<std::string> order;
  for (const auto& row : report.at("rows")) {
    const auto remark = row.at("remark").get<std::string>();
    if (remark.empty()) continue;
    auto& rows = rows_with[remark];
    if (rows.empty()) order.push_back(remark);
    rows +=
        (rows.empty() ? "" : ", ") +
        fmt::format("{} at h = {:.3g}", row.at("scheme").get<std::string>(), *number(row, "step"));
  }
  std::string text;
  for (const auto& remark : order) {
    text += wrapped(fmt::format("  {}: {}", rows_with[remark], remark), width, 4);
  }
  return text;
}

constexpr const char* kLegend =
    "h: velocity step; l: step of the fourth difference (pade has none). symbol: largest growth rate "
    "of a wave exp(i q y') under the excitation alone. matrix: eigenvalues of the whole operator with "
    "the largest real parts; the stationary density's is 0, the next is the slowest decay. in time: "
    "what becomes of any disturbance. null vector: distance to the jump equation kf on the same grid, and the "
    "least value relative to the peak.";

}  // namespace

std::string regularisation_table(const Json& report, const TextFormat& format) {
  std::string text = wrapped(case_title(report), format.width, 2) + rows(columns(report), format) +
                     remarks(report, format.width);
  for (const auto& sentence :
       {literal_sentence(report), regularised_sentence(report), threshold_sentence(report)}) {
    text += wrapped("  " + sentence, format.width, 2);
  }
  return text + '\n' + wrapped(kLegend, format.width);
}

}  // namespace fpkcheck::compare
