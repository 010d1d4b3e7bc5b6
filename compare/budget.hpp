#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/names.hpp"
#include "compare/axes.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// The error budget of a closure: its distance to the truth, split along the chain of models.
namespace fpkcheck::compare {

/// In what one model of the chain differs from the next.
enum class Link { closure, impact, truncation, white_noise, discretisation, sampling };
inline constexpr base::Named<Link> kLinkNames[] = {
    {Link::closure, "closure", "the closure itself"},
    {Link::impact, "impact", "the impact to first order in 1-r"},
    {Link::truncation, "truncation", "the cut of the Kramers-Moyal series"},
    {Link::white_noise, "white noise", "white noise in place of impulses"},
    {Link::discretisation, "discretisation", "the discretisation of the reference"},
    {Link::sampling, "sampling", "the sampling of the reference"}};
constexpr std::span<const base::Named<Link>> names(Link) { return kLinkNames; }
constexpr std::string_view name(Link link) { return base::name_of(link); }

/// "closure", or several joined: "closure + impact".
std::string name(const std::vector<Link>& links);
/// The links of such a name.
/// @throws InputError when it names none
std::vector<Link> links_named(std::string_view name);

/// One step of the chain.
struct BudgetPart {
  std::vector<Link> links;  ///< several where the models between them are missing
  std::string from;         ///< ids of the two ends
  std::string to;
  double l1;
  double tail;                          ///< as BudgetRow::total_tail; NaN without a bin
  std::optional<double> uncertainty{};  ///< discretisation errors of both ends, added
  std::optional<double> expected{};     ///< of a step to the simulation: its L1 sampling error
  std::optional<double> in_99{};        ///< ... and what 99 runs of 100 stay below
  /// Of a step to the smooth measure: that of its l1.
  std::optional<double> standard_error{};

  std::string name() const { return compare::name(links); }
  /// True for what every closure's chain ends with: discretisation and sampling.
  bool beyond_the_equations() const;
};

/// The budget of one closure in one variable. total <= sum of the parts, and the same in the tail:
/// both distances obey the triangle inequality.
struct BudgetRow {
  std::string solution;  ///< the closure
  transform::Variable variable;
  std::string reference;  ///< the last node: "mcs", "fd-kf limit" or "fd-kf"
  double total;           ///< L1 distance of closure and reference
  /// Mean of |log10 p - log10 reference| over `tail_bins`; NaN when there is none.
  double total_tail;
  double tail_from, tail_to;  ///< range of the reference density that is called the tail
  /// Bins of that range in which every node of the chain is positive and known well: the same ones
  /// for every part, or the parts would not bound the total.
  int tail_bins;
  std::vector<BudgetPart> parts;

  /// The part of this name, or null.
  const BudgetPart* find(std::string_view part) const;
};

/// The budgets of all closures that have a density, by solution; none without a chain's end, or
/// where no model stands between any closure and a simulation, so that nothing is split.
/// @param marginals of the solutions over even bins, or all of them in smooth bins
std::vector<BudgetRow> error_budget(const ComparisonAxes& axes,
                                    std::span<const transform::Solution> solutions,
                                    std::span<const SolutionMarginal> marginals);

/// The rows of one closure.
struct ClosureBudget {
  std::string solution;
  transform::Status status;  ///< of the closure
  const BudgetRow* y = nullptr;
  const BudgetRow* ydot = nullptr;  ///< null where a variable has none

  const BudgetRow* row(transform::Variable variable) const {
    return variable == transform::Variable::y ? y : ydot;
  }
  /// Those that are there.
  std::vector<const BudgetRow*> rows() const;
};

/// The closures of a budget, in its order; pointing into it.
std::vector<ClosureBudget> closure_budgets(std::span<const BudgetRow> budget,
                                           std::span<const transform::Solution> solutions);

/// Names of all parts, in the order of the chain.
std::vector<std::string> part_names(std::span<const ClosureBudget> budgets);

}  // namespace fpkcheck::compare
