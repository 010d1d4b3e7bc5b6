#pragma once

#include <optional>
#include <vector>

#include "results/run.hpp"

/// The verdict on a run: the accuracy of the reference, the solutions that reproduce the reference,
/// and the recommended method.
namespace fpkcheck::report {

using compare::Agreement;

/// A solution of a case, and its agreement with the reference of the case.
struct AgreementEntry : compare::SolutionAssessment {
  const transform::Solution* solution = nullptr;  ///< null where it is absent
};

/// The assessment of the solution `id` of a case.
AgreementEntry agreement_entry(const results::CaseResult& one, std::string_view id);

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
  int case_count_with(Agreement agreement) const;
  /// Largest L1 distance of one marginal density from that of the reference, over the cases in
  /// which the solution has a density; empty if there is no such case.
  std::optional<double> largest_l1_of(std::optional<double> AgreementEntry::*marginal) const;
  /// Largest L1 distance of both marginal densities over the cases.
  std::optional<double> largest_l1() const;
  /// Longest wall-clock time of the solution over the cases, in seconds.
  double longest_seconds() const;
};

/// The matrix rows of all solutions of a run, with a row for each id, by increasing trust as in the
/// cases.
std::vector<AgreementRow> agreement_rows(const results::Run& run);

}  // namespace fpkcheck::report
