#pragma once

#include "epc/form/exponent_polynomial.hpp"
#include "problem/problem.hpp"

/// Selection policy of the closures: initial densities and weights that depend on the class of the
/// problem. The file epc/selection_policy.cpp states the reason for each choice.
namespace fpkcheck::epc {

/// Returns whether the formulation `moment` starts from the Gaussian density of equivalent
/// linearisation at order 2. For all other problems the formulation `moment` starts from the
/// density of energy averaging at closure order 4.
bool starts_from_equivalent_linearisation(const problem::Problem& problem);

/// Returns the standard deviations of the Gaussian weights of paper (25)-(26): the deviations of
/// equivalent linearisation, or else the root mean squares of y and v by energy averaging.
StandardDeviations gaussian_weight_deviations(const problem::Problem& problem);

}  // namespace fpkcheck::epc
