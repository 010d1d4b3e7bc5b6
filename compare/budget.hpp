#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "compare/axes.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// The error budget of a closure: its distance from the reference, split along the chain of models.
namespace fpkcheck::compare {

/// The approximation in which consecutive models of the chain differ.
enum class Link { closure, impact, truncation, white_noise, discretisation, sampling };
inline constexpr base::EnumEntry<Link> kLinkNames[] = {
    {Link::closure, "closure", "the closure approximation"},
    {Link::impact, "impact", "the impact to first order in 1-r"},
    {Link::truncation, "truncation", "the truncation of the Kramers-Moyal series"},
    {Link::white_noise, "white noise", "white noise in place of impulses"},
    {Link::discretisation, "discretisation", "the discretisation of the reference"},
    {Link::sampling, "sampling", "the sampling error of the reference"}};
constexpr std::span<const base::EnumEntry<Link>> names(Link) { return kLinkNames; }
constexpr std::string_view name(Link link) { return base::name_of(link); }

/// The name of joined links: "closure", "closure + impact".
std::string name(const std::vector<Link>& links);
/// The links of a joined name.
/// @throws InputError when the name contains an unknown link
std::vector<Link> parse_links(std::string_view name);

/// A step of the chain, from one model to the next.
struct BudgetPart {
  std::vector<Link> links;  ///< several if the models between them are missing
  std::string from;         ///< ids of the two models
  std::string to;
  double l1;
  double tail;                          ///< as BudgetRow::total_tail; NaN without a bin
  std::optional<double> uncertainty{};  ///< sum of the discretisation errors of both models
  std::optional<double> expected{};     ///< expected L1 sampling error of a step to the simulation
  std::optional<double> quantile_99{};  ///< 99 % quantile of this sampling error
  /// Standard error of l1, for a step to the smooth reference.
  std::optional<double> standard_error{};

  std::string name() const { return compare::name(links); }
  /// True if the part consists of errors of the reference: discretisation and sampling.
  bool is_reference_error() const;
};

/// The budget of one closure in one variable. The total is at most the sum of the parts, also in
/// the tail: both distances satisfy the triangle inequality.
struct BudgetRow {
  std::string solution;  ///< the closure
  transform::Variable variable;
  std::string reference;  ///< the last node: "mcs", "fd-kf limit" or "fd-kf"
  double total;           ///< L1 distance of closure and reference
  /// Mean of |log10 p - log10 reference| over `tail_bins`; NaN without a bin.
  double total_tail;
  double tail_from, tail_to;  ///< range of the reference density that defines the tail
  /// Number of tail bins in which every node of the chain is positive and has a narrow interval.
  /// All parts use the same bins; otherwise the parts would not bound the total.
  int tail_bins;
  std::vector<BudgetPart> parts;

  /// The part with this name, or null.
  const BudgetPart* find(std::string_view part) const;
};

/// The budgets of all closures with a density, in the order of the solutions. Empty if no chain has
/// an end, or if every chain is a single step from a closure to a simulation.
/// @param marginals marginals of the solutions, either all over uniform or all over smooth bins
std::vector<BudgetRow> error_budget(const ComparisonAxes& axes,
                                    std::span<const transform::Solution> solutions,
                                    std::span<const SolutionMarginal> marginals);

/// The rows of one closure.
struct ClosureBudget {
  std::string solution;
  transform::Status status;  ///< status of the closure
  const BudgetRow* y = nullptr;
  const BudgetRow* ydot = nullptr;  ///< null if the variable has no budget

  const BudgetRow* row(transform::Variable variable) const {
    return variable == transform::Variable::y ? y : ydot;
  }
  /// The rows that are not null.
  std::vector<const BudgetRow*> rows() const;
};

/// The closures of a budget, in its order. The results point into `budget`.
std::vector<ClosureBudget> closure_budgets(std::span<const BudgetRow> budget,
                                           std::span<const transform::Solution> solutions);

/// The names of all parts, in the order of the chain.
std::vector<std::string> part_names(std::span<const ClosureBudget> budgets);

}  // namespace fpkcheck::compare
