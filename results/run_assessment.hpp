#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

/// The assessment of a run over all its cases, from which `report` makes the verdict.
namespace fpkcheck::results {

/// The assessment of a solution in one case. If the case does not contain the solution, the
/// `agreement` with the reference is `absent`.
struct SolutionAgreementInCase : compare::SolutionAssessment {
  const transform::Solution* solution = nullptr;  ///< null if the case lacks the solution
};

/// The agreement of one solution with the references of all cases of a run.
struct SolutionAgreementOverCases {
  const transform::SolutionIdentity* identity;   ///< identity in the first case with the solution
  std::vector<SolutionAgreementInCase> entries;  ///< in the order of the cases

  int case_count() const;
  int reproduced_case_count() const;
  /// Returns the number of cases in which the solution has the given agreement with the reference.
  int case_count_with_agreement(compare::AgreementWithReference agreement) const;
  /// Returns the largest L1 distance of one marginal density (p(y) or p(y')) from the references,
  /// over all cases in which the solution has a density. The largest L1 distance is empty if the
  /// solution has no density in any case.
  std::optional<double> largest_l1_distance_of_marginal(
      std::optional<double> SolutionAgreementInCase::*marginal) const;
  std::optional<double> largest_l1_distance() const;
  double longest_solve_seconds() const;
};

/// L1 distances of the marginal densities p(y) and p(y') from the reference, as far as known.
struct MarginalDistances {
  std::optional<double> y, ydot;

  bool has_both_distances() const { return y && ydot; }
  bool has_any_distance() const { return y || ydot; }
  /// Replaces each stored L1 distance by the corresponding argument if the argument is larger.
  void update_largest_l1_distances(const std::optional<double>& other_y,
                                   const std::optional<double>& other_ydot);
};

/// Names of the cases that belong to each solution id.
using CaseNamesBySolution = std::map<std::string, std::vector<std::string>>;
/// Returns the sum, over all solutions, of the numbers of cases that belong to a solution.
int case_count_over_solutions(const CaseNamesBySolution& cases);

/// The assessment of a run over all its cases. The rows of the assessment contain pointers to
/// solutions and identities of the run.
struct RunAssessment {
  /// Rows of the assessment, one row for each solution id, by increasing trust.
  std::vector<SolutionAgreementOverCases> rows = {};
  CaseNamesBySolution references = {};  ///< names of cases, by the id of the reference
  /// Largest L1 error estimates of the references over all cases; infinite if the reference of a
  /// case has no error estimate.
  double reference_y_l1 = 0, reference_ydot_l1 = 0;
  /// Cases in which a confirming solution agrees with the reference (`confirming`) or disagrees
  /// with the reference (`contradicting`), by the id of the confirming solution. The confirming
  /// solution is the most trusted solution of the full problem other than the reference.
  CaseNamesBySolution confirming = {}, contradicting = {};
  /// Largest L1 distances between references and confirming solutions, over all cases.
  MarginalDistances confirmation_distances = {};

  /// Returns the fastest solution with sufficient accuracy and status `ok` in every case, or null.
  /// External densities cannot be the fastest accurate solution. The accuracy of a solution is
  /// sufficient if the L1 distance from the reference plus the error estimate of the reference is
  /// at most `accuracy`.
  const SolutionAgreementOverCases* fastest_accurate_solution(double accuracy) const;
};

RunAssessment assess_run(const Run& run);

}  // namespace fpkcheck::results
