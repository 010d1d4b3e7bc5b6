#pragma once

#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "results/run.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {

/// The result of the comparison between a run and its baseline.
struct CheckResult {
  Tolerances tolerances;
  std::vector<QuantityChange> changes;  ///< all compared quantities, in the order of the baseline
  std::size_t solutions;                ///< number of solutions of the baseline
  std::vector<std::string> notes;

  std::vector<QuantityChange> changed_quantities() const;
  bool agrees_with_baseline() const;
};

/// Compares the quantities that two runs share, and reports the quantities that only one run has.
/// Times, options and metrics of kind work or text are not compared, since such values describe the
/// computation and not the solution.
/// @param now a run that this program has solved, so that each metric has a kind
/// @throws InputError if the new run lacks a case of the baseline
CheckResult check(const results::Run& baseline, const results::Run& now,
                  const Tolerances& tolerances, bool with_marginals = true);

/// The result of the comparison between two runs as text for the terminal: the quantities that
/// changed, for each kind the largest change within its tolerance, and a closing sentence.
std::string check_table(const CheckResult& check, const report::TextFormat& format);

/// The result of the comparison in JSON, the contents of check.json.
/// @param baseline path of the baseline, as the user typed it
std::string check_json(const CheckResult& check, const std::string& command,
                       const std::string& baseline);

/// The number of compared quantities of one kind, and the number of quantities whose change exceeds
/// the tolerance.
struct QuantityKindSummary {
  QuantityKind kind;
  std::size_t count = 0;
  std::size_t moved = 0;
  const QuantityChange* largest = nullptr;  ///< within its tolerance, and closest to it
};

/// Summaries of the kinds of quantities that occur in a check, in the order of the enum. The
/// pointers in the summaries refer to `check`.
std::vector<QuantityKindSummary> summarise_by_kind(const CheckResult& check);

}  // namespace fpkcheck::check
