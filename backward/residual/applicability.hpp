#pragma once

#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// The reason why DensityResiduals does not support a problem, in one phrase. Empty if the problem
/// is supported.
std::string residuals_unsupported_reason(const problem::Problem& problem);

}  // namespace fpkcheck::backward
