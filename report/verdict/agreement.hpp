#pragma once

#include <optional>
#include <vector>

#include "results/run.hpp"

/// The verdict on a run: accuracy of the reference, solutions that reproduce it, recommendation.
namespace fpkcheck::report {

/// A solution is close if neither marginal exceeds this L1 distance: the default accuracy required
/// of closures.
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

/// A solution in a case and its agreement with the reference.
struct AgreementEntry {
  Agreement agreement = Agreement::absent;
  const transform::Solution* solution = nullptr;  ///< null where it is absent
  std::optional<double> y{}, ydot{};              ///< L1 distances to the reference, where known

  /// The larger of the known distances.
  std::optional<double> largest_l1() const;
  /// Whether the solution is the reference, indistinguishable from it or within kCloseL1 of it.
  bool reproduces() const;
};

/// The agreement of the solution `id` with the reference of a case. An external density with a
/// single marginal is assessed by this marginal.
AgreementEntry agreement_entry(const results::Case& one, std::string_view id);

/// A solution over the cases of a run: a row of the matrix of agreements.
struct AgreementRow {
  const transform::Identity* identity;  ///< from the first case with the solution
  std::vector<AgreementEntry> entries;  ///< in the order of the cases

  /// Number of cases with the solution.
  int case_count() const;
  /// Number of cases in which the solution reproduces the reference.
  int reproduced_count() const;
  /// Number of cases with this agreement.
  int count(Agreement agreement) const;
  /// Largest distance of a marginal over the cases with a density, if any.
  std::optional<double> largest_l1_of(std::optional<double> AgreementEntry::*marginal) const;
  /// Largest distance of both marginals.
  std::optional<double> largest_l1() const;
  /// Longest time over the cases.
  double seconds() const;
};

/// The rows of all solutions of a run, a row per id, by increasing trust as in the cases.
std::vector<AgreementRow> agreement_rows(const results::Run& run);

}  // namespace fpkcheck::report
