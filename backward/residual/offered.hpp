#pragma once

#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Why no density of a problem is judged by its residuals (DensityResiduals), in one phrase; empty
/// where they are.
std::string residuals_refused(const problem::Problem& problem);

}  // namespace fpkcheck::backward
