#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the walls at which a solution of the case has an atom (mass at rest in contact), in
/// increasing order. For the cases of the paper the list of walls is empty.
std::vector<double> walls_with_rest_atoms(const results::CaseResult& case_result);

/// Returns the header of the column of a wall: "P(rest)", or "P(rest at -0.5)" if several walls
/// have atoms.
std::string rest_probability_header(const results::CaseResult& case_result, double wall);

/// Returns the probability of rest at a wall; NaN if the solution has no atom at the wall.
double rest_atom_probability(const transform::Solution& solution, double wall);

}  // namespace fpkcheck::report
