#include "compare/case_report.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::compare {
namespace {

using transform::Variable;

bool has_marginal(const transform::Solution& solution, Variable variable,
                  const std::vector<double>& bins) {
  return solution.density ||
         std::ranges::any_of(solution.estimated_marginals, [&](const auto& estimate) {
           return estimate.first == variable && estimate.second.edges == bins;
         });
}

}  // namespace

CaseReport report_on_case(const problem::Problem& problem, const ComparisonAxes& axes,
                          std::vector<Entry> entries) {
  CaseReport report{problem, axes, std::move(entries), {}, {}};
  for (const auto variable : {Variable::y, Variable::ydot}) {
    const auto& bins = edges(axes, variable);
    std::vector<SolutionMarginal> found;
    for (const auto& [solution, options, details] : report.entries) {
      if (!has_marginal(solution, variable, bins)) continue;
      found.push_back({solution.id, variable, transform::marginal(solution, variable, bins)});
    }
    for (std::size_t a = 0; a < found.size(); ++a) {
      for (std::size_t b = a + 1; b < found.size(); ++b) {
        report.comparisons.push_back({found[a].solution, found[b].solution, variable,
                                      distances(found[a].marginal, found[b].marginal)});
      }
    }
    std::ranges::move(found, std::back_inserter(report.marginals));
  }
  return report;
}

}  // namespace fpkcheck::compare
