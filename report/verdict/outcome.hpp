#pragma once

#include <optional>
#include <string>

#include "report/verdict/agreement.hpp"

namespace fpkcheck::report {

/// L1 distances of the marginals p(y) and p(y'); a missing distance is empty.
struct MarginalDistances {
  std::optional<double> y, ydot;

  bool has_both() const { return y && ydot; }
  bool any() const { return y || ydot; }
  /// Replaces each distance by the maximum of itself and the argument.
  void take_maximum(const std::optional<double>& other_y, const std::optional<double>& other_ydot);
};

/// "0.0061 in p(y) and 0.0051 in p(y')".
std::string distances_text(const MarginalDistances& distances);

/// "" for a single case, " in all 4 cases", " in 2 of 4 cases".
std::string cases_phrase(int count, int cases);

/// The outcome of a solution over the cases in words: "reproduced: L1 distance at most ..", "not
/// reproduced: inadmissible in all 4 cases: no probability density".
/// @param reference names of the references of the cases
std::string outcome(const AgreementRow& row, const std::string& reference, int cases);

/// The outcome of a solution without distances: "not_converged in all 4 cases: no solution found".
std::string brief_outcome(const AgreementRow& row, int cases);

}  // namespace fpkcheck::report
