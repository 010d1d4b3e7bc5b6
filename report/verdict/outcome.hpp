#pragma once

#include <optional>
#include <string>

#include "report/verdict/agreement.hpp"

namespace fpkcheck::report {

/// L1 distances of the marginal densities p(y) and p(y') to the reference; an unknown distance is
/// empty.
struct MarginalDistances {
  std::optional<double> y, ydot;

  bool has_both_distances() const { return y && ydot; }
  bool has_any_distance() const { return y || ydot; }
  /// Replaces each distance by the maximum of the distance and the corresponding argument.
  void take_larger_distances(const std::optional<double>& other_y,
                             const std::optional<double>& other_ydot);
};

/// The text of both distances: "0.0061 in p(y) and 0.0051 in p(y')".
std::string distances_text(const MarginalDistances& distances);

/// The phrase for a number of cases: " in all 4 cases", " in 2 of 4 cases"; empty for a run of a
/// single case.
std::string cases_phrase(int count, int cases);

/// The outcome of a solution over the cases in words: "reproduced: L1 distance at most ..", "not
/// reproduced: inadmissible in all 4 cases: no probability density".
/// @param reference name of the reference, or names if the references of the cases differ
/// @param cases number of cases of the run
std::string outcome_text(const AgreementRow& row, const std::string& reference, int cases);

/// The outcome of a solution without distances: "not_converged in all 4 cases: no solution found".
std::string outcome_text_without_distances(const AgreementRow& row, int cases);

}  // namespace fpkcheck::report
