#pragma once

#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Why DensityResiduals does not support a problem, in one phrase; empty if it does.
std::string residuals_unsupported_reason(const problem::Problem& problem);

}  // namespace fpkcheck::backward
