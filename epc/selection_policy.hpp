#pragma once

#include "epc/form/polynomial.hpp"
#include "problem/problem.hpp"

/// The selection policy of the closures: all choices of start and weight that depend on the class
/// of the problem. The reason or experiment for each choice is in selection_policy.cpp.
namespace fpkcheck::epc {

/// Whether the formulation moment starts from the Gaussian density of equivalent linearisation at
/// order 2. Otherwise the formulation starts from the density of energy averaging at order 4.
bool starts_from_linearisation(const problem::Problem& problem);

/// Standard deviations sigma_1 and sigma_2 of the weights f1 and f2 of paper (25)-(26), in the
/// formulation gaussian: the deviations of equivalent linearisation, or else the root mean squares
/// of y and v by energy averaging.
StandardDeviations weight_deviations(const problem::Problem& problem);

}  // namespace fpkcheck::epc
