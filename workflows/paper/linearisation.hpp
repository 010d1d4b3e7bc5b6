#pragma once

#include "results/run.hpp"

namespace fpkcheck::paper {

/// L1 distance of a marginal from that of the Gaussian of equivalent linearisation, (25)-(26), in
/// the curve's bins; of y as (30) makes it from that of z.
double l1_to_linearisation(const results::Curve& curve, const problem::Problem& problem);

}  // namespace fpkcheck::paper
