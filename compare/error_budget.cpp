#include "compare/error_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "compare/distances.hpp"
#include "compare/model_chain.hpp"
#include "compare/smooth_reference.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Marginal;
using transform::Solution;
using transform::SolutionRole;
using transform::StateVariable;
using transform::Status;

// The tail of a density consists of the two decades below the densities that contribute to the L1
// distance. In the tail of a density, the 95 % confidence intervals of a simulation of the default
// length are within +-40 % of the density.
constexpr double kTailFrom = 1e-5, kTailTo = 1e-3;
constexpr std::string_view kApproximationSeparator = " + ";

std::vector<std::size_t> tail_bins(const std::vector<ModelInApproximationChain>& chain) {
  const Marginal& reference = chain.back().marginal;
  std::vector<std::size_t> bins;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    if (reference.density[k] < kTailFrom || reference.density[k] >= kTailTo) continue;
    if (std::ranges::all_of(chain, [k](const ModelInApproximationChain& node) {
          return node.marginal.density[k] > 0 && has_narrow_confidence_interval(node.marginal, k);
        })) {
      bins.push_back(k);
    }
  }
  return bins;
}

double tail_distance(const Marginal& a, const Marginal& b, const std::vector<std::size_t>& bins) {
  if (bins.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const auto k : bins) sum += std::abs(std::log10(a.density[k]) - std::log10(b.density[k]));
  return sum / static_cast<double>(bins.size());
}

ErrorBudgetPart make_error_budget_part(StateVariable variable,
                                       const ModelInApproximationChain& from,
                                       const ModelInApproximationChain& to,
                                       const std::vector<std::size_t>& bins) {
  ErrorBudgetPart part{.approximations = to.approximations,
                       .from = from.id,
                       .to = to.id,
                       .l1 = compute_distances(from.marginal, to.marginal).l1,
                       .tail = tail_distance(from.marginal, to.marginal, bins)};
  if (from.discretisation_error && to.discretisation_error) {
    part.uncertainty = *from.discretisation_error + *to.discretisation_error;
  }
  if (to.sampling) {
    part.expected = expected_l1_error(*to.sampling, variable);
    part.quantile_99 = l1_error_quantile_99(*to.sampling, variable);
  }
  if (to.smooth != nullptr) part.standard_error = l1_standard_error(from.marginal, *to.smooth);
  return part;
}

ErrorBudgetRow make_error_budget_row(const Solution& closure, StateVariable variable,
                                     const std::vector<ModelInApproximationChain>& chain) {
  const auto bins = tail_bins(chain);
  const ModelInApproximationChain &first = chain.front(), &last = chain.back();
  ErrorBudgetRow row{.solution = closure.id(),
                     .variable = variable,
                     .reference = last.id,
                     .total = compute_distances(first.marginal, last.marginal).l1,
                     .total_tail = tail_distance(first.marginal, last.marginal, bins),
                     .tail_from = kTailFrom,
                     .tail_to = kTailTo,
                     .tail_bins = static_cast<int>(bins.size()),
                     .parts = {}};
  for (std::size_t k = 1; k < chain.size(); ++k) {
    row.parts.push_back(make_error_budget_part(variable, chain[k - 1], chain[k], bins));
  }
  return row;
}

// Returns false if the only part of the error budget is the distance from the closure to a
// simulation, which equals the total distance.
bool has_parts_besides_total(const ErrorBudgetRow& row, std::span<const Solution> solutions) {
  if (row.parts.size() > 1) return true;
  const Solution* end = transform::find_solution(solutions, row.reference);
  return end == nullptr || end->identity.role != SolutionRole::simulation;
}

}  // namespace

std::string name(const std::vector<ModelApproximation>& approximations) {
  std::string text;
  for (const ModelApproximation approximation : approximations) {
    if (!text.empty()) text += kApproximationSeparator;
    text += name(approximation);
  }
  return text;
}

std::vector<ModelApproximation> parse_approximations(std::string_view text) {
  std::vector<ModelApproximation> approximations;
  for (std::string_view rest = text;;) {
    const auto end = rest.find(kApproximationSeparator);
    const auto approximation = base::enum_from_name<ModelApproximation>(rest.substr(0, end));
    if (!approximation) {
      throw InputError(fmt::format(
          "unknown part of an error budget: {}; repeat the run with this version of the program",
          base::in_quotes(text)));
    }
    approximations.push_back(*approximation);
    if (end == std::string_view::npos) return approximations;
    rest.remove_prefix(end + kApproximationSeparator.size());
  }
}

bool ErrorBudgetPart::is_reference_error() const {
  return std::ranges::all_of(approximations, [](ModelApproximation approximation) {
    return approximation == ModelApproximation::discretisation ||
           approximation == ModelApproximation::sampling;
  });
}

const ErrorBudgetPart* ErrorBudgetRow::find_budget_part(std::string_view part) const {
  const auto found = std::ranges::find(parts, part, &ErrorBudgetPart::error_budget_part_name);
  return found == parts.end() ? nullptr : &*found;
}

std::vector<ErrorBudgetRow> compute_error_budget(
    const ComparisonBins& axes, std::span<const Solution> solutions,
    std::span<const SolutionMarginalDensity> marginals) {
  std::vector<ErrorBudgetRow> budget;
  for (const auto& solution : solutions) {
    if (solution.identity.role != SolutionRole::closure) continue;
    for (const auto variable : transform::kVariables) {
      const auto chain = make_model_chain(axes, solutions, marginals, solution, variable);
      if (!chain.empty()) budget.push_back(make_error_budget_row(solution, variable, chain));
    }
  }
  if (std::ranges::none_of(budget, [&](const ErrorBudgetRow& row) {
        return has_parts_besides_total(row, solutions);
      })) {
    return {};
  }
  return budget;
}

std::vector<const ErrorBudgetRow*> ClosureErrorBudget::existing_budget_rows() const {
  std::vector<const ErrorBudgetRow*> both{y, ydot};
  std::erase(both, nullptr);
  return both;
}

std::vector<ClosureErrorBudget> group_budget_by_closure(std::span<const ErrorBudgetRow> budget,
                                                        std::span<const Solution> solutions) {
  std::vector<ClosureErrorBudget> closures;
  for (const auto& row : budget) {
    auto found = std::ranges::find(closures, row.solution, &ClosureErrorBudget::solution);
    if (found == closures.end()) {
      const Solution* solution = transform::find_solution(solutions, row.solution);
      found = closures.insert(found,
                              {row.solution, solution == nullptr ? Status::ok : solution->status});
    }
    (row.variable == StateVariable::y ? found->y : found->ydot) = &row;
  }
  return closures;
}

std::vector<std::string> budget_part_names(std::span<const ClosureErrorBudget> budgets) {
  std::vector<std::string> names;
  for (const auto& budget : budgets) {
    for (const ErrorBudgetRow* row : budget.existing_budget_rows()) {
      // The name of a new part of the budget is inserted before the name that follows in the same
      // budget row, to keep the order of the model chain.
      auto at = names.end();
      for (auto part = row->parts.rbegin(); part != row->parts.rend(); ++part) {
        const auto place = std::ranges::find(names, part->error_budget_part_name());
        at = place != names.end() ? place : names.insert(at, part->error_budget_part_name());
      }
    }
  }
  return names;
}

}  // namespace fpkcheck::compare
