#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/case_report.hpp"

/// The error budget of a closure: its distance to the truth, split along the chain of models.
namespace fpkcheck::compare {

/// One link of the chain.
struct BudgetPart {
  std::string name;  ///< "closure", "impact", .., or several joined by " + "
  std::string from;  ///< ids of the two ends
  std::string to;
  double l1;
  double tail;                          ///< as BudgetRow::total_tail; NaN without a bin
  std::optional<double> uncertainty{};  ///< discretisation errors of both ends, added
  std::optional<double> expected{};     ///< of a link to the simulation: its L1 sampling error
  std::optional<double> in_99{};        ///< ... and what 99 runs of 100 stay below
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
};

/// The budgets of all closures that have a density, by variable; none without a reference.
std::vector<BudgetRow> error_budget(const CaseReport& report);

/// "budget" of a case in summary.json.
nlohmann::ordered_json to_json(const std::vector<BudgetRow>& budget);

}  // namespace fpkcheck::compare
