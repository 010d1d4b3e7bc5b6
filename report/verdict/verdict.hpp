#pragma once

#include <string>
#include <vector>

#include "report/verdict/agreement.hpp"

namespace fpkcheck::report {

/// The outcome of a method, or of one order of a closure, in one line.
struct VerdictLine {
  std::string subject;  ///< "epc-gaussian-n6", "epc-polar"
  bool reproduced;      ///< the references of all cases with this solution are reproduced
  std::string outcome;  ///< "reproduced: L1 distance at most 0.0061 in p(y) and 0.0051 in p(y')"
};

/// The main result of a run, shown before all tables.
struct Verdict {
  std::vector<AgreementRow>
      agreement_rows;  ///< rows of the matrix, for all solutions; point into the run
  /// Paragraphs: contradictions with the guaranteed bounds, the reference and its accuracy, the
  /// solutions that reproduce it.
  std::vector<std::string> answer;
  /// A line for each order of the closure with first-order impact (the paper's), each other
  /// formulation, each approximate equation, and each external density or family of external
  /// densities.
  std::vector<VerdictLine> lines;
  /// The recommended method, the fastest method of sufficient accuracy, and the reasons.
  std::vector<std::string> recommendation;
};

Verdict verdict(const results::Run& run);

}  // namespace fpkcheck::report
