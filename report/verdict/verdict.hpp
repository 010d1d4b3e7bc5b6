#pragma once

#include <string>
#include <vector>

#include "report/verdict/outcome.hpp"

namespace fpkcheck::report {

/// One line of the verdict: the outcome of a method, or of one order of a closure.
struct VerdictLine {
  std::string subject;  ///< id or family, such as "epc-gaussian-n6" or "epc-polar"
  bool reproduced;      ///< whether the method reproduces the reference in each of its cases
  std::string outcome;  ///< "reproduced: L1 distance at most 0.0061 in p(y) and 0.0051 in p(y')"
};

/// The main result of a run, printed before all tables.
struct Verdict {
  /// Rows of the matrix of the verdict, one for each solution.
  std::vector<SolutionAgreements> agreement_rows;
  /// Paragraphs on contradictions with the guaranteed bounds, on the accuracy of the reference, and
  /// on the solutions that reproduce the reference.
  std::vector<std::string> answer;
  /// Outcomes of the methods, one line each. There is a line for each order of the paper's closure
  /// (with the impact condition to first order in 1-r), for each further formulation, for each
  /// approximate equation, and for each external density or family of densities.
  std::vector<VerdictLine> lines;
  /// Sentences that recommend the solution for reference values and the fastest method of
  /// sufficient accuracy, with the reasons.
  std::vector<std::string> recommendation;
};

Verdict make_verdict(const results::Run& run);

}  // namespace fpkcheck::report
