#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// The walls at which some solution of a case rests in contact, increasing; none in the paper.
std::vector<double> walls_of_rest(const results::Case& one);

/// The head of a column: "P(rest)", or "P(rest at -0.5)" where there are several.
std::string rest_header(const results::Case& one, double wall);

/// The probability of rest at a wall; NaN where the solution has no such atom.
double probability_of_rest(const transform::Solution& solution, double wall);

}  // namespace fpkcheck::report
