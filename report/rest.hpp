#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// The walls at which a solution of the case has an atom (mass at rest in contact), in increasing
/// order. Empty for the cases of the paper.
std::vector<double> walls_of_rest(const results::Case& one);

/// The header of the column of a wall: "P(rest)", or "P(rest at -0.5)" if several walls have atoms.
std::string rest_header(const results::Case& one, double wall);

/// The probability of the atom at a wall; NaN if the solution has no atom there.
double probability_of_rest(const transform::Solution& solution, double wall);

}  // namespace fpkcheck::report
