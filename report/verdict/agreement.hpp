#pragma once

#include <optional>
#include <vector>

#include "results/run.hpp"

/// The verdict on a run: the accuracy of the reference, the solutions that reproduce the reference,
/// and the recommended method.
namespace fpkcheck::report {

/// Limit for close solutions: a solution is close if both marginal densities are within this L1
/// distance of the reference. The limit for close solutions is the default accuracy required of
/// closures.
inline constexpr double kCloseL1 = 0.02;

/// Agreement of a solution with the reference of its case.
enum class Agreement {
  absent,             ///< the case has no such solution
  no_density,         ///< no admissible density: none found, or inadmissible
  no_reference,       ///< a density, but no distance to a reference
  reference,          ///< the solution is the reference
  indistinguishable,  ///< distances within the error estimate of the reference
  close,              ///< both marginals within kCloseL1
  distant             ///< a marginal farther away than kCloseL1
};

/// A solution of a case, and its agreement with the reference of the case.
struct AgreementEntry {
  Agreement agreement = Agreement::absent;
  const transform::Solution* solution = nullptr;  ///< null where it is absent
  std::optional<double> y{}, ydot{};              ///< L1 distances to the reference, where known

  /// The larger of the known L1 distances of both marginal densities.
  std::optional<double> largest_l1() const;
  /// Whether the solution reproduces the reference: the solution is the reference, or is
  /// indistinguishable from the reference, or has distances of at most kCloseL1.
  bool reproduces_reference() const;
};

/// The agreement of the solution `id` with the reference of a case. An external density with a
/// single marginal density is assessed by this marginal density.
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
