#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

/// The assessment of a run over all its cases, from which `report` makes the verdict.
namespace fpkcheck::results {

/// The assessment of a solution in one case. If the case lacks the solution, `agreement` is
/// `absent`.
struct AgreementInCase : compare::SolutionAssessment {
  const transform::Solution* solution = nullptr;  ///< null if the case lacks the solution
};

/// The agreement of one solution with the references of all cases of a run.
struct SolutionAgreements {
  const transform::SolutionIdentity* identity;  ///< identity in the first case with the solution
  std::vector<AgreementInCase> entries;         ///< in the order of the cases

  int case_count() const;
  int reproduced_case_count() const;
  /// Returns the number of cases in which the solution has the given agreement with the reference.
  int case_count_with_agreement(compare::Agreement agreement) const;
  /// Returns the largest L1 distance of p(y) or p(y') from the reference over the cases with a
  /// density, or nothing if the solution has no density in any case.
  std::optional<double> largest_l1_of_marginal(
      std::optional<double> AgreementInCase::*marginal) const;
  std::optional<double> largest_l1() const;
  double longest_seconds() const;
};

/// L1 distances of p(y) and p(y') from the reference. An unknown distance is empty.
struct MarginalDistances {
  std::optional<double> y, ydot;

  bool has_both_distances() const { return y && ydot; }
  bool has_any_distance() const { return y || ydot; }
  /// Replaces each distance by the larger of the distance and the corresponding argument.
  void update_maximum_distances(const std::optional<double>& other_y,
                                const std::optional<double>& other_ydot);
};

/// Names of cases, by id of a solution.
using CaseNamesBySolution = std::map<std::string, std::vector<std::string>>;
/// Returns the number of cases, summed over all solutions.
int case_count(const CaseNamesBySolution& cases);

/// The assessment of a run over all its cases. The pointers in the rows point into the run.
struct RunAssessment {
  /// One row for each id of a solution, by increasing trust.
  std::vector<SolutionAgreements> rows = {};
  CaseNamesBySolution references = {};  ///< cases by id of their reference
  /// Largest L1 error estimates of the references over the cases; infinite if a case has no
  /// estimate.
  double reference_y_l1 = 0, reference_ydot_l1 = 0;
  /// Cases in which the most trusted solution of the full problem besides the reference agrees with
  /// the reference (`confirming`) or disagrees (`contradicting`). The keys are the ids of these
  /// solutions.
  CaseNamesBySolution confirming = {}, contradicting = {};
  /// Largest distances of the confirming and contradicting solutions from the references.
  MarginalDistances confirmation_distances = {};

  /// Returns the fastest solution with sufficient accuracy and status `ok` in every case, or null.
  /// External densities are excluded. The accuracy is sufficient if the distance from the reference
  /// plus the error estimate of the reference is at most `accuracy`.
  const SolutionAgreements* fastest_accurate_solution(double accuracy) const;
};

RunAssessment assess_run(const Run& run);

}  // namespace fpkcheck::results
