#pragma once

#include "epc/form/exponent_polynomial.hpp"
#include "problem/problem.hpp"

/// Selection of initial densities and Gaussian weights of the closures, depending on the class of
/// the problem. The file epc/selection_policy.cpp states the reason for each selected initial
/// density and Gaussian weight.
namespace fpkcheck::epc {

/// Returns whether the root search of the formulation `moment` starts from the Gaussian density of
/// equivalent linearisation, at closure order 2. For all other problems the root search of the
/// formulation `moment` starts from the energy-averaged density, at closure order 4.
bool starts_from_equivalent_linearisation(const problem::Problem& problem);

/// Returns the standard deviations of the Gaussian weights (25)-(26) of the paper: the standard
/// deviations of equivalent linearisation, or else the root mean squares of y and v under the
/// energy-averaged density.
StandardDeviations gaussian_weight_deviations(const problem::Problem& problem);

}  // namespace fpkcheck::epc
