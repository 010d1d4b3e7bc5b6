#include "compare/solution_assessment.hpp"

#include <algorithm>
#include <cmath>

#include "compare/agreement.hpp"

namespace fpkcheck::compare {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::Solution;
using transform::SolutionRole;
using transform::StateVariable;

namespace {

constexpr double kUnknownError = std::numeric_limits<double>::infinity();

const Solution* select_reference(std::span<const Solution> solutions) {
  const Solution* best = nullptr;
  for (const auto& solution : solutions) {
    if (solution.identity.role == SolutionRole::measurement && solution.has_density())
      return &solution;
    if (!is_solution_of_full_problem(solution)) continue;
    if (best == nullptr || !(l1_error_estimate(*best) < l1_error_estimate(solution)))
      best = &solution;
  }
  return best;
}

std::optional<ReferenceConfirmation> find_reference_confirmation(
    const Solution& reference, std::span<const Solution> solutions,
    std::span<const SolutionPairDistances> pairs) {
  const Solution* second = nullptr;
  for (const auto& solution : solutions) {
    if (&solution != &reference && is_solution_of_full_problem(solution)) second = &solution;
  }
  if (second == nullptr) return std::nullopt;
  return ReferenceConfirmation{second->id(), solutions_agree(reference, *second, pairs)};
}

// Returns whether the L1 distances of p(y) and p(y') from the reference are at most the error
// estimates of the reference.
bool is_within_reference_error(const SolutionsAssessment& assessment,
                               const SolutionAssessment& solution) {
  const auto within = [](const std::optional<double>& l1, double error) {
    return !l1 || (std::isfinite(error) && *l1 <= error);
  };
  return within(solution.y, assessment.reference_y_l1) &&
         within(solution.ydot, assessment.reference_ydot_l1);
}

AgreementWithReference classify_agreement(const SolutionsAssessment& assessment,
                                          const Solution& solution,
                                          const SolutionAssessment& assessed) {
  if (assessed.id == assessment.reference) return AgreementWithReference::reference;
  if (!solution.has_density() || solution.status == transform::Status::inadmissible)
    return AgreementWithReference::no_density;
  const auto l1 = assessed.largest_l1_distance();
  if (!l1) return AgreementWithReference::no_reference;
  if (is_within_reference_error(assessment, assessed))
    return AgreementWithReference::indistinguishable;
  return *l1 <= kCloseL1 ? AgreementWithReference::close : AgreementWithReference::distant;
}

double l1_sum(const SolutionAssessment& closure) { return *closure.y + *closure.ydot; }

void rank_closures(std::span<const Solution> solutions, SolutionsAssessment& assessment) {
  std::vector<SolutionAssessment*> closures;
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    auto& assessed = assessment.solutions[k];
    const bool is_ranked =
        solutions[k].identity.role == SolutionRole::closure && solutions[k].has_status_ok();
    if (is_ranked && assessed.y && assessed.ydot) closures.push_back(&assessed);
  }
  std::ranges::stable_sort(closures, {}, [](const auto* closure) { return l1_sum(*closure); });
  int rank = 0;
  for (auto* closure : closures) closure->rank = ++rank;
}

}  // namespace

double l1_error_estimate(const Solution& solution, StateVariable variable) {
  const auto& sampling = smallest_known_sampling_errors(solution);
  const auto by_chance = sampling ? expected_l1_error(*sampling, variable) : std::nullopt;
  if (!solution.error && !by_chance) return kUnknownError;
  const double by_method = solution.error ? l1_error_of_marginal(*solution.error, variable) : 0;
  return by_method + by_chance.value_or(0);
}

double l1_error_estimate(const Solution& solution) {
  return l1_error_estimate(solution, StateVariable::y) +
         l1_error_estimate(solution, StateVariable::ydot);
}

bool is_solution_of_full_problem(const Solution& solution) {
  const auto& identity = solution.identity;
  const bool independent =
      identity.role == SolutionRole::equation || identity.role == SolutionRole::simulation;
  return solution.has_status_ok() && solution.has_density() && independent &&
         identity.equation == DensityEquation::kf && identity.impact &&
         *identity.impact != ImpactCondition::delta;
}

std::optional<double> SolutionAssessment::largest_l1_distance() const {
  if (y && ydot) return std::max(*y, *ydot);
  return y ? y : ydot;
}

bool SolutionAssessment::reproduces_reference() const {
  return agreement == AgreementWithReference::reference ||
         agreement == AgreementWithReference::indistinguishable ||
         agreement == AgreementWithReference::close;
}

bool SolutionsAssessment::is_reference_selected_by_error() const {
  return std::isfinite(reference_y_l1 + reference_ydot_l1);
}

double SolutionsAssessment::largest_reference_l1_error() const {
  return std::max(reference_y_l1, reference_ydot_l1);
}

const SolutionAssessment* SolutionsAssessment::find_solution_assessment(std::string_view id) const {
  const auto found = std::ranges::find(solutions, id, &SolutionAssessment::id);
  return found == solutions.end() ? nullptr : &*found;
}

std::vector<const SolutionAssessment*> SolutionsAssessment::closures_ranked_by_distance() const {
  std::vector<const SolutionAssessment*> closures;
  for (const auto& solution : solutions) {
    if (solution.rank) closures.push_back(&solution);
  }
  std::ranges::stable_sort(closures, {}, [](const auto* closure) { return *closure->rank; });
  return closures;
}

bool SolutionsAssessment::are_closures_indistinguishable(const SolutionAssessment& first,
                                                         const SolutionAssessment& second) const {
  return is_reference_selected_by_error() &&
         std::abs(l1_sum(first) - l1_sum(second)) <= reference_y_l1 + reference_ydot_l1;
}

SolutionsAssessment assess_solutions(std::span<const Solution> solutions,
                                     std::span<const SolutionPairDistances> pairs,
                                     std::span<const ErrorBudgetRow> budget) {
  SolutionsAssessment assessment;
  if (const Solution* reference = select_reference(solutions)) {
    const auto known = [&](StateVariable variable) {
      const double error = l1_error_estimate(*reference, variable);
      return reference->has_status_ok() && std::isfinite(error) ? error : kUnknownError;
    };
    assessment.reference = reference->id();
    assessment.is_reference_chosen_by_user = reference->identity.role == SolutionRole::measurement;
    assessment.reference_y_l1 = known(StateVariable::y);
    assessment.reference_ydot_l1 = known(StateVariable::ydot);
    assessment.confirmation = find_reference_confirmation(*reference, solutions, pairs);
  }
  for (const auto& solution : solutions) {
    SolutionAssessment assessed{.id = solution.id()};
    if (!assessment.reference.empty() && assessed.id != assessment.reference) {
      assessed.y = l1_distance_between(pairs, assessed.id, assessment.reference, StateVariable::y);
      assessed.ydot =
          l1_distance_between(pairs, assessed.id, assessment.reference, StateVariable::ydot);
    }
    assessed.agreement = classify_agreement(assessment, solution, assessed);
    assessment.solutions.push_back(std::move(assessed));
  }
  rank_closures(solutions, assessment);
  assessment.limiting_errors = find_limiting_errors(budget, solutions, pairs);
  return assessment;
}

}  // namespace fpkcheck::compare
