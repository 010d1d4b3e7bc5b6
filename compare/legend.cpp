#include "compare/legend.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace fpkcheck::compare {
namespace {

bool any_group(const std::vector<Column>& columns, std::string_view start) {
  return std::ranges::any_of(columns, [&](const Column& c) { return c.group.starts_with(start); });
}

bool any_header(const std::vector<Column>& columns, std::string_view part) {
  return std::ranges::any_of(
      columns, [&](const Column& c) { return c.header.find(part) != std::string::npos; });
}

template <class Condition>
bool any_cell(const std::vector<Column>& columns, std::string_view header, Condition condition) {
  return std::ranges::any_of(columns, [&](const Column& c) {
    return c.header == header && std::ranges::any_of(c.cells, condition);
  });
}

std::string solves_text(const std::vector<Column>& results) {
  constexpr std::pair<const char*, const char*> kEquations[] = {
      {"white", "white noise"},
      {"km4", "Kramers-Moyal series to the fourth derivative"},
      {"km4-pade", "Pade approximant of the Kramers-Moyal series"},
      {"kf", "full jump integral"}};
  constexpr std::pair<const char*, const char*> kImpacts[] = {{"map", "exact"},
                                                              {"delta", "to first order in 1-r"}};
  std::vector<std::string> equations, impacts;
  for (const auto& [name, meaning] : kEquations) {
    if (any_cell(results, "solves",
                 [&](const auto& cell) { return cell.starts_with(std::string(name) + '/'); })) {
      equations.push_back(fmt::format("{}: {}", name, meaning));
    }
  }
  for (const auto& [name, meaning] : kImpacts) {
    if (any_cell(results, "solves",
                 [&](const auto& cell) { return cell.ends_with('/' + std::string(name)); })) {
      impacts.push_back(fmt::format("{}: {}", name, meaning));
    }
  }
  std::vector<std::string> terms;
  if (!equations.empty()) {
    terms.push_back(fmt::format("the excitation term ({})", fmt::join(equations, "; ")));
  }
  if (!impacts.empty()) terms.push_back(fmt::format("the impact ({})", fmt::join(impacts, "; ")));
  if (any_cell(results, "solves", [](const auto& cell) { return cell.starts_with("given/"); })) {
    terms.emplace_back("given: from a file");
  }
  return fmt::format("solves: {}.", fmt::join(terms, " / "));
}

}  // namespace

std::string results_legend(const std::vector<Column>& results) {
  std::vector<std::string> sentences;
  const bool distances = any_group(results, "L1");
  if (distances) {
    sentences.emplace_back(
        "L1: integral of |p - reference|, 0 for equal densities, 2 for disjoint ones.");
  }
  if (any_header(results, "solves")) sentences.push_back(solves_text(results));
  if (any_header(results, "energy")) {
    sentences.emplace_back("energy: residual of the power balance relative to the input.");
  }
  if (any_header(results, "sec")) sentences.emplace_back("sec: wall-clock time.");
  if (distances || any_header(results, "E[")) {
    sentences.emplace_back(any_header(results, "sec") ? "All else is non-dimensional."
                                                      : "All is non-dimensional.");
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

std::string budget_legend(const std::vector<Column>& budgets) {
  if (budgets.empty()) return "";
  const auto has_row = [&](std::string_view name) {
    return any_cell(budgets, "error budget", [&](const auto& cell) { return cell == name; });
  };
  std::vector<std::string> rows_below;
  for (const char* name : {"discretisation", "sampling", "discretisation + sampling"}) {
    if (has_row(name)) rows_below.emplace_back(name);
  }
  std::string text =
      "error budget: the L1 distance from each closure to the reference (total) is at most the sum "
      "of its parts";
  if (!rows_below.empty()) {
    text += fmt::format(" and of the row{} {}", rows_below.size() > 1 ? "s" : "",
                        fmt::join(rows_below, " and "));
  }
  // Links without a density between them share a column, as closure + impact.
  constexpr std::pair<const char*, const char*> kParts[] = {
      {"closure", "closure: against finite differences of the closure's own equation"},
      {"impact", "impact: to first order in 1-r instead of exact"},
      {"trunc", "trunc.: the series cut after the fourth derivative instead of all jumps"},
      {"white", "white: white noise instead of impulses"}};
  for (const auto& [header, meaning] : kParts) {
    if (any_header(budgets, header)) text += fmt::format("; {}", meaning);
  }
  if (any_group(budgets, "tail")) text += "; tail: mean |log10 p - log10 reference|";
  if (any_cell(budgets, "error budget", [](const auto& cell) { return cell.ends_with('*'); })) {
    text += "; *: the closure found no admissible density";
  }
  return text + '.';
}

}  // namespace fpkcheck::compare
