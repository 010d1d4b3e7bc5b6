#pragma once

#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "results/run.hpp"
#include "workflows/check/quantity_change.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {

/// The result of comparing a run with its baseline.
struct Check {
  Tolerances tolerances;
  std::vector<QuantityChange> changes;  ///< all compared quantities, in the order of the baseline
  std::size_t solutions;                ///< number of solutions of the baseline
  std::vector<std::string> notes;

  std::vector<QuantityChange> moved() const;
  bool agrees() const;
};

/// Compares the quantities that two runs share, and reports those that only one run has. Times,
/// options and metrics of kind work or text are not compared: they describe the computation, not
/// the solution.
/// @param now a run that was solved by this program: its metrics have kinds
/// @throws InputError when the new run lacks a case
Check check(const results::Run& baseline, const results::Run& now, const Tolerances& tolerances,
            bool with_marginals = true);

/// Text for the terminal: what changed, for each kind the largest change that is within its
/// tolerance, and a closing sentence.
std::string check_table(const Check& check, const report::TextFormat& format);

/// Contents of check.json.
/// @param baseline path of the baseline, as the user typed it
std::string check_json(const Check& check, const std::string& command, const std::string& baseline);

/// Counts of the compared quantities of one kind.
struct KindSummary {
  QuantityKind kind;
  std::size_t count = 0;
  std::size_t moved = 0;
  const QuantityChange* largest = nullptr;  ///< within its tolerance, and closest to it
};

/// Summaries of the kinds that occur, in the order of the enum. Their pointers refer to `check`.
std::vector<KindSummary> summarise_by_kind(const Check& check);

}  // namespace fpkcheck::check
