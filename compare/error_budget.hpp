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

/// An approximation that one model of the chain makes and the next model avoids.
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

std::string name(const std::vector<Approximation>& approximations);
/// Parses names such as "closure + impact".
/// @throws InputError if the name contains an unknown approximation
std::vector<Approximation> parse_approximations(std::string_view name);

/// One part of an error budget: the distance between two consecutive models of the chain.
struct ErrorBudgetPart {
  /// Approximations in which the two models differ; several if intermediate models are missing.
  std::vector<Approximation> approximations;
  std::string from;  ///< id of the model with the approximations
  std::string to;    ///< id of the model without the approximations
  double l1;
  /// Tail distance of the two models over the tail bins (ErrorBudgetRow::tail_bins); NaN without a
  /// tail bin.
  double tail;
  std::optional<double> uncertainty{};  ///< sum of the discretisation errors of both models
  /// Expected L1 sampling error of the model `to`, if this model is a simulation.
  std::optional<double> expected{};
  /// 99 % quantile of the L1 sampling error of the model `to`.
  std::optional<double> quantile_99{};
  /// Standard error of `l1`, if `to` is the smooth reference (compare/smooth_reference.hpp).
  std::optional<double> standard_error{};

  std::string name() const { return compare::name(approximations); }
  /// Returns whether the part consists only of discretisation and sampling errors of the reference.
  bool is_reference_error() const;
};

/// The error budget of one closure in one variable. By the triangle inequality the total distance
/// is at most the sum of the distances of the parts, for L1 distances and for tail distances.
struct ErrorBudgetRow {
  std::string solution;  ///< id of the closure
  transform::StateVariable variable;
  std::string reference;  ///< id of the last model of the chain: "mcs", "fd-kf limit" or "fd-kf"
  double total;
  /// Tail distance of the closure from the reference: the mean of |log10 p - log10 p_reference|
  /// over the tail bins; NaN without a tail bin.
  double total_tail;
  /// Range of the reference density in tail bins, tail_from <= p_reference < tail_to.
  double tail_from, tail_to;
  /// Number of tail bins. In a tail bin the density of every model of the chain is positive and has
  /// a narrow confidence interval. All parts use the same tail bins, since otherwise the triangle
  /// inequality would not hold.
  int tail_bins;
  std::vector<ErrorBudgetPart> parts;  ///< in the order of the chain

  const ErrorBudgetPart* find(std::string_view part) const;
};

/// Returns the error budgets of all closures with a density, in the order of the solutions. The
/// list is empty if no chain of models reaches the full problem, or if every budget has only one
/// part, from the closure to a simulation.
/// @param marginals marginal densities of the solutions, all over uniform bins or all over smooth
///        bins
std::vector<ErrorBudgetRow> error_budget(const ComparisonAxes& axes,
                                         std::span<const transform::Solution> solutions,
                                         std::span<const SolutionMarginal> marginals);

struct ClosureErrorBudget {
  std::string solution;
  transform::Status status;
  const ErrorBudgetRow* y = nullptr;
  const ErrorBudgetRow* ydot = nullptr;

  const ErrorBudgetRow* row(transform::StateVariable variable) const {
    return variable == transform::StateVariable::y ? y : ydot;
  }
  /// Returns the existing budgets, y before y'.
  std::vector<const ErrorBudgetRow*> rows() const;
};

/// Groups the rows of an error budget by closure. The pointers in the result point into `budget`.
std::vector<ClosureErrorBudget> closure_error_budgets(
    std::span<const ErrorBudgetRow> budget, std::span<const transform::Solution> solutions);

/// Returns the names of all parts, without repetitions and in the order of the chain of models.
std::vector<std::string> budget_part_names(std::span<const ClosureErrorBudget> budgets);

}  // namespace fpkcheck::compare
