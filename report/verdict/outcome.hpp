#pragma once

#include <optional>
#include <string>

#include "report/verdict/standing.hpp"

namespace fpkcheck::report {

/// L1 distances of both marginals, or of the one that is known.
struct MarginalDistances {
  std::optional<double> y, ydot;

  bool whole() const { return y && ydot; }
  bool any() const { return y || ydot; }
  /// The larger ones of what is there and these.
  void widen(const std::optional<double>& other_y, const std::optional<double>& other_ydot);
};

/// "0.0061 in p(y) and 0.0051 in p(y')".
std::string text_of(const MarginalDistances& distances);

/// "" of one case, " in all 4 cases", " in 2 of 4 cases".
std::string in_cases(int count, int cases);

/// What became of a solution over the cases, in words: "reproduced: off by at most ..", "not
/// reproduced: inadmissible in all 4 cases: no probability density".
/// @param reference what it was measured by
std::string outcome(const Record& record, const std::string& reference, int cases);

/// The same where there is no distance: "not_converged in all 4 cases: no solution found".
std::string brief_outcome(const Record& record, int cases);

}  // namespace fpkcheck::report
