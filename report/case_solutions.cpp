#include "report/case_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "compare/solution_assessment.hpp"

namespace fpkcheck::report {

std::vector<const transform::Solution*> solutions_of_full_problem(
    const results::CaseResult& case_result) {
  const auto* chosen = case_result.reference_solution();
  if (chosen == nullptr) return {};
  std::vector<const transform::Solution*> all{chosen};
  for (const auto& solution : case_result.solutions) {
    if (&solution != chosen && compare::is_solution_of_full_problem(solution))
      all.push_back(&solution);
  }
  return all;
}

std::string reference_description_text(const results::CaseResult& case_result) {
  const auto& assessment = case_result.assessment;
  if (assessment.reference.empty())
    return "There is no reference: no solution of the full problem has status ok.";
  if (assessment.is_reference_chosen_by_user)
    return fmt::format("Reference: {}, as chosen by role=reference.", assessment.reference);
  const std::string known =
      assessment.is_reference_selected_by_error()
          ? fmt::format(
                ", the solution with the smallest error estimate (L1 {:.1g} in p(y), {:.1g} in "
                "p(y'))",
                assessment.reference_y_l1, assessment.reference_ydot_l1)
          : std::string();
  return fmt::format("Reference: {}{}.", assessment.reference, known);
}

using transform::Solution;

std::vector<SolutionFamily> group_by_family(const std::vector<const Solution*>& solutions) {
  std::vector<SolutionFamily> all;
  for (const Solution* solution : solutions) {
    const std::string& name = solution->identity.family;
    auto found = std::ranges::find(all, name, &SolutionFamily::name);
    if (found == all.end()) found = all.insert(found, {name, {}});
    found->solutions.push_back(solution);
  }
  return all;
}

std::vector<SolutionFamily> group_by_family(std::span<const Solution> solutions) {
  std::vector<const Solution*> all;
  for (const auto& solution : solutions) all.push_back(&solution);
  return group_by_family(all);
}

std::vector<SolutionStatusReason> group_status_reasons(const results::CaseResult& case_result) {
  std::vector<SolutionStatusReason> all;
  for (const auto& solution : case_result.solutions) {
    if (solution.has_status_ok()) continue;
    const auto same = std::ranges::find_if(all, [&](const SolutionStatusReason& reason) {
      return reason.status == transform::Status::not_offered && reason.status == solution.status &&
             reason.text == solution.reason;
    });
    if (same != all.end()) {
      same->solutions.push_back(solution.id());
    } else {
      all.push_back({{solution.id()}, solution.status, solution.reason});
    }
  }
  return all;
}

std::vector<double> walls_with_rest_atoms(const results::CaseResult& case_result) {
  std::set<double> walls;
  for (const auto& solution : case_result.solutions) {
    for (const auto& atom : solution.atoms) walls.insert(atom.y);
  }
  return {walls.begin(), walls.end()};
}

std::string rest_probability_header(const results::CaseResult& case_result, double wall) {
  return walls_with_rest_atoms(case_result).size() == 1 ? std::string("P(rest)")
                                                        : fmt::format("P(rest at {:g})", wall);
}

double rest_atom_probability(const transform::Solution& solution, double wall) {
  const auto found = std::ranges::find(solution.atoms, wall, &transform::RestAtom::y);
  return found == solution.atoms.end() ? std::numeric_limits<double>::quiet_NaN()
                                       : found->probability;
}

}  // namespace fpkcheck::report
