#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "compare/limiting_errors.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// The assessment of the solutions of a case: the reference, the agreement of each solution with
/// the reference, and the ranks of the closures. Tables, plots, the page and sentences show the
/// assessment and decide nothing.
namespace fpkcheck::compare {

/// Limit for close solutions: a solution is close if both marginal densities are within this L1
/// distance of the reference. The limit for close solutions is the default accuracy required of
/// closures.
inline constexpr double kCloseL1 = 0.02;

/// L1 error estimate of a marginal density: the error estimate of the method; without an error
/// estimate, the expected sampling error; without both, infinity.
double l1_error_estimate(const transform::Solution& solution, transform::Variable variable);
/// Sum of the L1 error estimates of both marginal densities.
double l1_error_estimate(const transform::Solution& solution);

/// Whether a solution has a density, the status ok, and solves the full problem: a density equation
/// or a simulation with the jump integral (`kf`) and the exact impact condition.
bool is_solution_of_full_problem(const transform::Solution& solution);

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
inline constexpr base::EnumEntry<Agreement> kAgreementNames[] = {
    {Agreement::absent, "absent"},
    {Agreement::no_density, "no_density"},
    {Agreement::no_reference, "no_reference"},
    {Agreement::reference, "reference"},
    {Agreement::indistinguishable, "indistinguishable"},
    {Agreement::close, "close"},
    {Agreement::distant, "distant"}};
constexpr std::span<const base::EnumEntry<Agreement>> enumerator_names(Agreement) {
  return kAgreementNames;
}
constexpr std::string_view name(Agreement agreement) { return base::name_of(agreement); }

/// The agreement of one solution with the reference of its case. An external density with a single
/// marginal density is assessed by this marginal density.
struct SolutionAssessment {
  std::string id = {};  ///< id of the solution
  Agreement agreement = Agreement::absent;
  std::optional<double> y = {}, ydot = {};  ///< L1 distances to the reference, where known
  /// Rank of a closure by the sum of both distances, from 1 for the closest closure. Empty for
  /// other solutions, for closures without status ok, and without a distance in either variable.
  std::optional<int> rank = {};

  /// The larger of the known L1 distances of both marginal densities.
  std::optional<double> largest_l1() const;
  /// Whether the solution reproduces the reference: the solution is the reference, or is
  /// indistinguishable from the reference, or has distances of at most kCloseL1.
  bool reproduces_reference() const;

  bool operator==(const SolutionAssessment&) const = default;
};

/// The most trusted solution of the full problem besides the reference.
struct Confirmation {
  std::string id;      ///< id of the solution
  bool has_agreement;  ///< the errors explain the distances to the reference (has_agreement())

  bool operator==(const Confirmation&) const = default;
};

/// The assessment of all solutions of a case.
struct Assessment {
  /// Id of the reference: the solution of the full problem with the smallest L1 error estimate,
  /// summed over both marginals. Among solutions with equal or missing error estimates, the most
  /// trusted solution is selected. Empty if no solution satisfies is_solution_of_full_problem().
  std::string reference = {};
  /// L1 error estimates of the reference in p(y) and in p(y'); infinite if unknown.
  double reference_y_l1 = std::numeric_limits<double>::infinity();
  double reference_ydot_l1 = std::numeric_limits<double>::infinity();
  std::optional<Confirmation> confirmation = {};   ///< empty without a second solution
  std::vector<SolutionAssessment> solutions = {};  ///< in the order of the solutions of the case
  LimitingErrors limiting_errors = {};             ///< limiting errors of the closures

  /// Whether the reference was selected by its error estimate, and not by trust.
  bool is_selected_by_error_estimate() const;
  /// The larger L1 error estimate of the reference of both marginal densities.
  double largest_reference_l1() const;
  /// The assessment of the solution with this id; null if there is none.
  const SolutionAssessment* find(std::string_view id) const;
  /// The closures with a rank, the closest closure first.
  std::vector<const SolutionAssessment*> ranked_closures() const;
  /// Whether the sums of the distances of two ranked closures differ by no more than the error
  /// estimate of the reference. With so small a difference, neither closure counts as closer to the
  /// reference.
  bool are_indistinguishable(const SolutionAssessment& first,
                             const SolutionAssessment& second) const;

  bool operator==(const Assessment&) const = default;
};

/// Assesses the solutions of a case.
/// @param solutions by increasing trust
/// @param pairs distances of the solutions; without distances the result has the reference, but no
///        agreement and no rank
/// @param budget error budgets of the closures
Assessment assess_solutions(std::span<const transform::Solution> solutions,
                            std::span<const PairDistances> pairs = {},
                            std::span<const ErrorBudgetRow> budget = {});

}  // namespace fpkcheck::compare
