#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// The bins on which every solution of one problem is compared.
struct ComparisonAxes {
  std::vector<double> y_edges;  ///< increasing, the first one 0
  std::vector<double> v_edges;  ///< increasing and symmetric, one of them 0
};

/// Uniform bins over 0 <= y <= y_s + 7 sigma_1 and |y'| <= 7 sigma_2, with the deviations of
/// equivalent linearisation and the static deflection y_s under the mean of the impulses (0 in the
/// paper). Only the problem decides them, so that a simulation can be given the same bins for its
/// histogram and nothing is interpolated for it.
ComparisonAxes comparison_axes(const problem::Problem& problem);

/// The edges of one variable.
const std::vector<double>& edges(const ComparisonAxes& axes, transform::Variable variable);

}  // namespace fpkcheck::compare
