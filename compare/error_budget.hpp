#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "compare/comparison_bins.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// The error budget of a closure: the L1 distance of the closure from the reference, split into
/// parts along a chain of models from the closure to the reference.
namespace fpkcheck::compare {

/// An approximation that one model in the chain from the closure to the reference makes and the
/// next model avoids.
enum class ModelApproximation {
  closure,
  impact,
  truncation,
  white_noise,
  discretisation,
  sampling
};
inline constexpr base::EnumEntry<ModelApproximation> kApproximationNames[] = {
    {ModelApproximation::closure, "closure", "the closure approximation"},
    {ModelApproximation::impact, "impact", "the impact to first order in 1-r"},
    {ModelApproximation::truncation, "truncation", "the truncation of the Kramers-Moyal series"},
    {ModelApproximation::white_noise, "white noise", "white noise in place of impulses"},
    {ModelApproximation::discretisation, "discretisation", "the discretisation of the reference"},
    {ModelApproximation::sampling, "sampling", "the sampling error of the reference"}};
constexpr const auto& enumerator_names(ModelApproximation) { return kApproximationNames; }
constexpr std::string_view name(ModelApproximation approximation) {
  return base::name_of(approximation);
}

std::string name(const std::vector<ModelApproximation>& approximations);
/// Parses the names of approximations such as "closure + impact".
/// @throws InputError if the name contains an unknown approximation
std::vector<ModelApproximation> parse_approximations(std::string_view name);

/// One part of an error budget: the L1 distance between two consecutive models in the chain from
/// the closure to the reference.
struct ErrorBudgetPart {
  /// Approximations that the model `from` in the chain makes and the model `to` avoids. A part of
  /// the error budget has several approximations if models of the chain are missing.
  std::vector<ModelApproximation> approximations;
  std::string from;  ///< id of the model with the approximations
  std::string to;    ///< id of the model without the approximations
  double l1;
  /// Mean absolute difference of the log10 of the densities of the models `from` and `to` over the
  /// tail bins (ErrorBudgetRow::tail_bins); NaN without a tail bin.
  double tail;
  std::optional<double> uncertainty{};  ///< sum of the discretisation errors of `from` and `to`
  /// Expected L1 sampling error of the density of the model `to`, if this model is a simulation.
  std::optional<double> expected{};
  /// 99 % quantile of the L1 sampling error of the model `to`, if this model is a simulation.
  std::optional<double> quantile_99{};
  /// Standard error of the L1 distance `l1`, if the model `to` is a simulation with control
  /// variates (compare/smooth_reference.hpp).
  std::optional<double> standard_error{};

  std::string error_budget_part_name() const { return compare::name(approximations); }
  /// Returns whether this part of the error budget contains only errors of the reference.
  bool is_reference_error() const;
};

/// The error budget of one closure in one variable, y or y'. By the triangle inequality, the total
/// L1 or tail distance is at most the sum of the parts of the error budget.
struct ErrorBudgetRow {
  std::string solution;  ///< id of the closure
  transform::StateVariable variable;
  std::string reference;  ///< id of the last model of the chain: "mcs", "fd-kf limit" or "fd-kf"
  double total;
  /// Distance of a closure density p from the reference density in the tail: the mean of |log10 p -
  /// log10 p_reference| over the tail bins; NaN without a tail bin.
  double total_tail;
  /// Range of the reference density that defines the tail bins, tail_from <= p_reference < tail_to.
  double tail_from, tail_to;
  /// Number of tail bins. In a tail bin the density of every model from the closure to the
  /// reference is positive and has a narrow confidence interval. All parts of an error budget use
  /// the same tail bins, as the triangle inequality requires.
  int tail_bins;
  std::vector<ErrorBudgetPart> parts;  ///< parts in the order of the model chain

  const ErrorBudgetPart* find_budget_part(std::string_view part) const;
};

/// Returns the error budgets of all closures with a density, in the given order of the solutions.
/// The list of error budgets is empty if no chain of models leads from a closure to the full
/// problem. The list is also empty if every error budget has only one part, from the closure to a
/// simulation.
/// @param marginals marginal densities of the solutions, all over uniform or all over smooth bins
std::vector<ErrorBudgetRow> compute_error_budget(
    const ComparisonBins& axes, std::span<const transform::Solution> solutions,
    std::span<const SolutionMarginalDensity> marginals);

struct ClosureErrorBudget {
  std::string solution;
  transform::Status status;
  const ErrorBudgetRow* y = nullptr;
  const ErrorBudgetRow* ydot = nullptr;

  const ErrorBudgetRow* budget_row_of(transform::StateVariable variable) const {
    return variable == transform::StateVariable::y ? y : ydot;
  }
  /// Returns the existing error budgets of the closure, that of y before that of y'.
  std::vector<const ErrorBudgetRow*> existing_budget_rows() const;
};

/// Groups the rows of an error budget by their closure. The pointers in the result refer to
/// elements of the argument `budget`.
std::vector<ClosureErrorBudget> group_budget_by_closure(
    std::span<const ErrorBudgetRow> budget, std::span<const transform::Solution> solutions);

/// Returns the distinct names of all parts of the error budgets, in the order of the models from
/// the closure to the reference.
std::vector<std::string> budget_part_names(std::span<const ClosureErrorBudget> budgets);

}  // namespace fpkcheck::compare
