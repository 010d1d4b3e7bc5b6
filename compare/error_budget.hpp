#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "compare/comparison_axes.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// The error budget of a closure: the L1 distance of the closure from the reference, split into
/// parts along the chain of models (compare/model_chain.hpp).
namespace fpkcheck::compare {

/// The approximation that a model in the chain of models makes and the next model does not make.
enum class Approximation { closure, impact, truncation, white_noise, discretisation, sampling };
inline constexpr base::EnumEntry<Approximation> kApproximationNames[] = {
    {Approximation::closure, "closure", "the closure approximation"},
    {Approximation::impact, "impact", "the impact to first order in 1-r"},
    {Approximation::truncation, "truncation", "the truncation of the Kramers-Moyal series"},
    {Approximation::white_noise, "white noise", "white noise in place of impulses"},
    {Approximation::discretisation, "discretisation", "the discretisation of the reference"},
    {Approximation::sampling, "sampling", "the sampling error of the reference"}};
constexpr const auto& enumerator_names(Approximation) { return kApproximationNames; }
constexpr std::string_view name(Approximation approximation) {
  return base::name_of(approximation);
}

/// The names of approximations, joined by " + ": "closure", "closure + impact".
std::string name(const std::vector<Approximation>& approximations);
/// The approximations in a name such as "closure + impact".
/// @throws InputError when the name contains an unknown approximation
std::vector<Approximation> parse_approximations(std::string_view name);

/// One part of an error budget: the distance between two consecutive models of the chain.
struct ErrorBudgetPart {
  /// Approximations in which the two models differ; several if the models between them are missing.
  std::vector<Approximation> approximations;
  std::string from;  ///< id of the model with the approximations
  std::string to;    ///< id of the model without the approximations
  double l1;         ///< L1 distance of the two models
  /// Tail distance of the two models, as ErrorBudgetRow::total_tail; NaN without a tail bin.
  double tail;
  std::optional<double> uncertainty{};  ///< sum of the discretisation errors of both models
  /// Expected L1 sampling error of the model `to`, if a simulation.
  std::optional<double> expected{};
  /// 99 % quantile of the L1 sampling error of the model `to`, if a simulation.
  std::optional<double> quantile_99{};
  /// Standard error of l1, if the model `to` is the smooth reference.
  std::optional<double> standard_error{};

  std::string name() const { return compare::name(approximations); }
  /// Whether the part consists only of errors of the reference: discretisation and sampling errors.
  bool is_reference_error() const;
};

/// The error budget of one closure in one variable. The total distance is at most the sum of the
/// parts, by the triangle inequality. By the same inequality, the total tail distance is at most
/// the sum of the tail distances of the parts.
struct ErrorBudgetRow {
  std::string solution;  ///< id of the closure
  transform::Variable variable;
  std::string reference;  ///< id of the last model of the chain: "mcs", "fd-kf limit" or "fd-kf"
  double total;           ///< L1 distance of the closure from the reference
  /// Tail distance of the closure from the reference: the mean of |log10 p - log10 p_reference|
  /// over the tail bins; NaN without a tail bin.
  double total_tail;
  /// Range of the reference density, tail_from <= p_reference < tail_to, in tail bins.
  double tail_from, tail_to;
  /// Number of tail bins. In a tail bin the density of every model of the chain is positive and has
  /// a narrow confidence interval. All parts use the same tail bins: otherwise the sum of their
  /// tail distances would not be an upper bound of the total tail distance.
  int tail_bins;
  std::vector<ErrorBudgetPart> parts;  ///< in the order of the chain

  /// The part with this name; null if there is none.
  const ErrorBudgetPart* find(std::string_view part) const;
};

/// The error budgets of all closures with a density, in the order of the solutions. The list is
/// empty if no chain of models reaches the full problem, or if every budget consists of a single
/// part, from the closure to a simulation.
/// @param marginals marginals of the solutions: all over uniform bins, or all over smooth bins
std::vector<ErrorBudgetRow> error_budget(const ComparisonAxes& axes,
                                         std::span<const transform::Solution> solutions,
                                         std::span<const SolutionMarginal> marginals);

/// The error budgets of one closure in both variables.
struct ClosureErrorBudget {
  std::string solution;                  ///< id of the closure
  transform::Status status;              ///< status of the closure
  const ErrorBudgetRow* y = nullptr;     ///< budget in y; null if there is none
  const ErrorBudgetRow* ydot = nullptr;  ///< budget in y'; null if there is none

  const ErrorBudgetRow* row(transform::Variable variable) const {
    return variable == transform::Variable::y ? y : ydot;
  }
  /// The budgets that exist, of y before y'.
  std::vector<const ErrorBudgetRow*> rows() const;
};

/// Groups the rows of an error budget by closure, in the order of the rows. The elements of the
/// result point into `budget`.
std::vector<ClosureErrorBudget> closure_error_budgets(
    std::span<const ErrorBudgetRow> budget, std::span<const transform::Solution> solutions);

/// The names of all parts of several budgets, each name once, in the order of the chain of models.
std::vector<std::string> budget_part_names(std::span<const ClosureErrorBudget> budgets);

}  // namespace fpkcheck::compare
