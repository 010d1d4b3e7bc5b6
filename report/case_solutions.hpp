#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// Returns the solutions of the full problem (exact impulses and impacts), with which reports
/// compare all other solutions. The first solution of the returned list is the reference solution
/// of the case. After the reference solution, the list keeps the order of the solutions in the
/// case. The list of solutions is empty if a case has no reference solution.
std::vector<const transform::Solution*> solutions_of_full_problem(
    const results::CaseResult& case_result);

/// Returns a sentence that names the reference solution of a case and states the reason for its
/// selection.
std::string reference_description_text(const results::CaseResult& case_result);

struct SolutionFamily {
  std::string name;
  std::vector<const transform::Solution*> solutions;
};

/// Groups solutions by family. The solution families are sorted by the position of their first
/// solution in `solutions`.
std::vector<SolutionFamily> group_by_family(
    const std::vector<const transform::Solution*>& solutions);
std::vector<SolutionFamily> group_by_family(std::span<const transform::Solution> solutions);

/// The reason why solutions of a case have a status other than `ok`. Solutions with status
/// `not_offered` and equal reasons share one SolutionStatusReason.
struct SolutionStatusReason {
  std::vector<std::string> solutions;  ///< ids in the order of the case
  transform::Status status;
  std::string text;
};

std::vector<SolutionStatusReason> group_status_reasons(const results::CaseResult& case_result);

/// Returns the walls at which a solution of the case has an atom (mass at rest in contact), in
/// increasing order. In the paper's four cases no mass rests in contact, and the list of walls is
/// empty.
std::vector<double> walls_with_rest_atoms(const results::CaseResult& case_result);

/// Returns the table header for the probability of rest at a wall: "P(rest)", or "P(rest at -0.5)"
/// if several walls have atoms.
std::string rest_probability_header(const results::CaseResult& case_result, double wall);

/// Returns the probability that the mass rests at a wall, or NaN for a solution without an atom at
/// the wall.
double rest_atom_probability(const transform::Solution& solution, double wall);

}  // namespace fpkcheck::report
