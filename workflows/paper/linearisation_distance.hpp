#pragma once

#include "results/run.hpp"

namespace fpkcheck::paper {

/// The L1 distance, in the bins of a curve, between a marginal density and the marginal density of
/// the Gaussian of equivalent linearisation, (25)-(26). The density of y follows from the density
/// of z by (30).
double l1_to_linearisation(const results::Curve& curve, const problem::Problem& problem);

}  // namespace fpkcheck::paper
