#pragma once

#include <string>
#include <vector>

#include "report/text/text_layout.hpp"
#include "results/run.hpp"
#include "workflows/check/compared_quantity.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {

struct BaselineCheckResult {
  BaselineCheckTolerances tolerances;
  /// All compared quantities, in the order of the baseline run.
  std::vector<CheckedQuantityChange> changes;
  std::size_t solutions;  ///< number of solutions in the baseline
  std::vector<std::string> notes;

  std::vector<CheckedQuantityChange> quantities_beyond_tolerance() const;
  bool agrees_with_baseline() const;
};

/// Compares all quantities of two runs, and reports quantities that only one run has. Computing
/// times, options and metrics of kind `work` or `text` are not compared, since they describe the
/// computation instead of the solution.
/// @param now new run by this program version, in which each metric has a kind
/// @throws InputError if the new run lacks a case of the baseline
BaselineCheckResult compare_runs(const results::Run& baseline, const results::Run& now,
                                 const BaselineCheckTolerances& tolerances,
                                 bool with_marginals = true);

/// Returns a table of the quantities with changes above tolerance, the largest change within
/// tolerance for each kind of quantity, and a closing sentence.
std::string check_result_table(const BaselineCheckResult& check,
                               const report::TerminalTextFormat& format);

/// Returns the result of `fpkcheck check` as JSON, the contents of check.json.
std::string check_result_json(const BaselineCheckResult& check, const std::string& command,
                              const std::string& baseline);

/// Numbers of compared quantities and of changes above the tolerance, for one kind of compared
/// quantity.
struct CheckedQuantityKindSummary {
  CheckedQuantityKind kind;
  std::size_t count = 0;
  std::size_t moved = 0;
  /// Change that is closest to its tolerance among all changes within tolerance.
  const CheckedQuantityChange* largest = nullptr;
};

/// Summarises the changes of compared quantities for each kind of quantity. The pointers in the
/// returned summaries refer to elements of the argument `check`.
std::vector<CheckedQuantityKindSummary> summarise_changes_by_kind(const BaselineCheckResult& check);

}  // namespace fpkcheck::check
