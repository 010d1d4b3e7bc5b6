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
/// the reference, and the ranks of the closures. The tables, plots and sentences of reports use no
/// criteria for the accuracy of solutions other than this assessment.
namespace fpkcheck::compare {

/// Largest L1 distance of p(y) and of p(y') from the reference for the agreement `close` of a
/// solution. The limit 0.02 of the L1 distance of `close` solutions equals the default accuracy
/// required of closures.
inline constexpr double kCloseL1 = 0.02;

/// Returns the L1 error estimate of a marginal density of a solution. The result is the error
/// estimate by the method of the solution, or else the expected sampling error. If a solution has
/// neither an error estimate nor an expected sampling error, the result is infinity.
double l1_error_estimate(const transform::Solution& solution, transform::StateVariable variable);
double l1_error_estimate(const transform::Solution& solution);

/// Returns whether a solution has a density and the status `ok`, and solves the full problem (all
/// impulses, exact impacts). A solution of the full problem discretises the density equation or
/// simulates trajectories, with the full jump integral (`kf`) and the exact impact condition.
bool is_solution_of_full_problem(const transform::Solution& solution);

enum class AgreementWithReference {
  absent,
  no_density,    ///< solution without a density, or with an inadmissible density
  no_reference,  ///< solution with a density but without a distance from a reference
  reference,
  indistinguishable,  ///< L1 distances of p(y) and p(y') within the error estimate of the reference
  close,              ///< L1 distances of p(y) and p(y') at most kCloseL1
  distant             ///< L1 distance of p(y) or of p(y') above kCloseL1
};
inline constexpr base::EnumEntry<AgreementWithReference> kAgreementNames[] = {
    {AgreementWithReference::absent, "absent"},
    {AgreementWithReference::no_density, "no_density"},
    {AgreementWithReference::no_reference, "no_reference"},
    {AgreementWithReference::reference, "reference"},
    {AgreementWithReference::indistinguishable, "indistinguishable"},
    {AgreementWithReference::close, "close"},
    {AgreementWithReference::distant, "distant"}};
constexpr std::span<const base::EnumEntry<AgreementWithReference>> enumerator_names(
    AgreementWithReference) {
  return kAgreementNames;
}
constexpr std::string_view name(AgreementWithReference agreement) {
  return base::name_of(agreement);
}

/// The agreement of one solution of a case with the reference solution. For an external solution
/// with only one marginal density, this marginal density determines the agreement.
struct SolutionAssessment {
  std::string id = {};
  AgreementWithReference agreement = AgreementWithReference::absent;
  std::optional<double> y = {}, ydot = {};  ///< L1 distances from the reference, if known
  /// Rank of a closure by the sum of its L1 distances of p(y) and p(y') from the reference; the
  /// closest closure has rank 1. Only closures with the status `ok` and with known L1 distances
  /// from the reference have a rank.
  std::optional<int> rank = {};

  /// Returns the larger of the known L1 distances `y` and `ydot` of a solution from the reference.
  std::optional<double> largest_l1_distance() const;
  /// Returns whether the solution is the reference, is indistinguishable from the reference, or has
  /// L1 distances from the reference of at most kCloseL1.
  bool reproduces_reference() const;

  bool operator==(const SolutionAssessment&) const = default;
};

/// The most trusted solution of the full problem other than the reference, which confirms or
/// contradicts the reference.
struct ReferenceConfirmation {
  std::string id;
  /// Whether the solution agrees with the reference within the errors of both (solutions_agree()).
  bool has_agreement;

  bool operator==(const ReferenceConfirmation&) const = default;
};

struct SolutionsAssessment {
  /// Id of the reference: the solution of the full problem with the smallest sum of the L1 error
  /// estimates of p(y) and p(y'). If the error estimates of several solutions are equal or missing,
  /// the most trusted solution is the reference. The id of the reference is empty if no solution
  /// satisfies is_solution_of_full_problem(). An external density that the user chose as the
  /// reference (SolutionRole::measurement) precedes all solutions.
  std::string reference = {};
  bool is_reference_chosen_by_user = false;
  /// L1 error estimates of p(y) and p(y') of the reference; infinite if unknown.
  double reference_y_l1 = std::numeric_limits<double>::infinity();
  double reference_ydot_l1 = std::numeric_limits<double>::infinity();
  std::optional<ReferenceConfirmation> confirmation = {};  ///< empty if no solution can confirm
  std::vector<SolutionAssessment> solutions = {};  ///< assessments in the order of the solutions
  LimitingErrorsOfClosures limiting_errors = {};

  /// Returns whether the reference solution was selected by its error estimate, not by trust.
  bool is_reference_selected_by_error() const;
  /// Returns the larger of the L1 error estimates of p(y) and p(y') of the reference.
  double largest_reference_l1_error() const;
  const SolutionAssessment* find_solution_assessment(std::string_view id) const;
  /// Returns the closures ranked by their L1 distances from the reference.
  std::vector<const SolutionAssessment*> closures_ranked_by_distance() const;
  /// Returns whether the sums of the L1 distances of two closures from the reference differ by at
  /// most the error estimate of the reference.
  bool are_closures_indistinguishable(const SolutionAssessment& first,
                                      const SolutionAssessment& second) const;

  bool operator==(const SolutionsAssessment&) const = default;
};

/// Assesses the solutions of a case. Without distances between solutions in `pairs`, the assessment
/// has the reference, but no agreement and no ranks.
/// @param solutions solutions of the case, by increasing trust
SolutionsAssessment assess_solutions(std::span<const transform::Solution> solutions,
                                     std::span<const SolutionPairDistances> pairs = {},
                                     std::span<const ErrorBudgetRow> budget = {});

}  // namespace fpkcheck::compare
