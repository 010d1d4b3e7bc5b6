#pragma once

#include "results/run.hpp"

namespace fpkcheck::paper {

/// L1 distance between a marginal density and that of the Gaussian of equivalent linearisation,
/// (25)-(26), in the curve's bins. The density of y follows from that of z by (30).
double l1_to_linearisation(const results::Curve& curve, const problem::Problem& problem);

}  // namespace fpkcheck::paper
