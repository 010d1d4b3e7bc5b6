#pragma once

#include <string>
#include <vector>

#include "report/verdict/standing.hpp"

namespace fpkcheck::report {

/// What stands of one method, or of one order of a closure, in a line.
struct VerdictLine {
  std::string subject;  ///< "epc-gaussian-n6", "epc-polar"
  bool reproduced;      ///< the reference of every case that it solved
  std::string outcome;  ///< "reproduced: off by at most 0.0061 in p(y) and 0.0051 in p(y')"
};

/// The answer of a run, before any table.
struct Verdict {
  std::vector<Record> records;  ///< of all solutions: the rows of the matrix; points into the run
  /// One sentence or two: what is known and how well, and who reproduces it.
  std::vector<std::string> answer;
  /// A line for each order of the closure of first-order impact (the paper's), for each other
  /// formulation, each equation that is not the problem's own, and each density of a user's, or family
  /// of several orders of these.
  std::vector<VerdictLine> lines;
  /// Which method to trust, which is the quickest that is as good, and why.
  std::vector<std::string> trust;
};

Verdict verdict(const results::Run& run);

}  // namespace fpkcheck::report
