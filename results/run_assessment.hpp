#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

/// The assessment of a run over its cases. The verdict of `report` shows this assessment in words.
namespace fpkcheck::results {

/// The assessment of a solution in one case, and the solution. The agreement of a solution that the
/// case does not have is `absent`.
struct AgreementEntry : compare::SolutionAssessment {
  const transform::Solution* solution = nullptr;  ///< null where it is absent
};

/// The agreement of one solution with the references over all cases of a run: a row of the matrix
/// of agreements.
struct AgreementRow {
  const transform::SolutionIdentity* identity;  ///< from the first case with the solution
  std::vector<AgreementEntry> entries;          ///< in the order of the cases

  /// Number of cases with the solution.
  int case_count() const;
  /// Number of cases in which the solution reproduces the reference.
  int reproduced_case_count() const;
  /// Number of cases in which the solution has this agreement with the reference.
  int case_count_with(compare::Agreement agreement) const;
  /// Largest L1 distance of one marginal density from that of the reference, over the cases in
  /// which the solution has a density; empty if there is no such case.
  std::optional<double> largest_l1_of(std::optional<double> AgreementEntry::*marginal) const;
  /// Largest L1 distance of both marginal densities over the cases.
  std::optional<double> largest_l1() const;
  /// Longest wall-clock time of the solution over the cases, in seconds.
  double longest_seconds() const;
};

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

/// The names of the cases for each id of a solution.
using CasesBySolution = std::map<std::string, std::vector<std::string>>;
/// Number of all cases.
int case_count(const CasesBySolution& cases);

/// The assessment of a run over its cases. The elements point into the run.
struct RunAssessment {
  /// The rows of all solutions, with a row for each id, by increasing trust as in the cases.
  std::vector<AgreementRow> rows = {};
  CasesBySolution references = {};  ///< the references and their cases
  /// Largest L1 error estimates of the references over the cases; infinite if unknown in a case.
  double reference_y_l1 = 0, reference_ydot_l1 = 0;
  /// The most trusted solutions of the full problem besides the references: cases in which the
  /// solution and the reference agree, and cases in which they disagree.
  CasesBySolution confirming = {}, contradicting = {};
  /// Largest distances of these solutions to the references over the cases.
  MarginalDistances confirmation_distances = {};

  /// The fastest solution, except external densities, that has status ok and sufficient accuracy in
  /// every case; null if there is none. The accuracy is sufficient if the distance to the reference
  /// plus the error estimate of the reference is at most `accuracy`.
  const AgreementRow* fastest_row(double accuracy) const;
};

RunAssessment assess_run(const Run& run);

}  // namespace fpkcheck::results
