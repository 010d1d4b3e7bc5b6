#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/check/figure.hpp"
#include "compare/check/tolerances.hpp"
#include "compare/report.hpp"
#include "compare/text/format.hpp"

namespace fpkcheck::compare {

/// A run beside its baseline.
struct Check {
  Tolerances tolerances;
  std::vector<Figure> figures;  ///< all that were compared, in the order of the baseline
  std::size_t solutions;        ///< of the baseline
  std::vector<std::string> notes;

  std::vector<Figure> moved() const;
  bool agrees() const;
};

/// Compares what two runs hold in common and reports what only one of them has. Not compared are
/// times, counts of steps and residuals: they are how a solution came about, not what it is.
/// @throws InputError when a summary lacks what its schema promises
Check check(const SavedRun& baseline, const SavedRun& now, const Tolerances& tolerances,
            bool with_marginals = true);

/// For people: what moved, the largest change of each kind beside what is allowed, and a closing
/// sentence.
std::string check_table(const Check& check, const TextFormat& format);

/// For scripts: the contents of check.json.
/// @param baseline its path as given
nlohmann::ordered_json check_json(const Check& check, const std::string& command,
                                  const std::string& baseline);

}  // namespace fpkcheck::compare
