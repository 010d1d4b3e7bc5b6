#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// The bins of one problem's marginals: even ones, of which those at 0 may be divided. Solutions are
/// compared over the even bins: for what is narrower nobody states an error.
struct ComparisonAxes {
  std::vector<double> y_edges;  ///< increasing; the first one is the wall, 0, in the paper
  std::vector<double> v_edges;  ///< increasing and symmetric, one of them 0
  int divisions = 0;            ///< edges within the first bin of y, and each of the two of y' at 0
};

/// Uniform bins over 0 <= y <= y_s + 7 sigma_1 and |y'| <= 7 sigma_2, with the deviations of
/// equivalent linearisation and the static deflection y_s under the mean of the impulses (0 in the
/// paper). Where the marginals are unbounded at rest (problem::impulses_per_decay_time below 1)
/// bins next to 0 are divided at 1/4, 1/16 and 1/64: each part then has a share of the mass there.
/// Other oscillators than the paper's have the ends of problem::scales, and no divisions.
/// Only the problem decides them, so that a simulation can be given the same bins for its
/// histogram and nothing is interpolated for it.
ComparisonAxes comparison_axes(const problem::Problem& problem);

/// The edges of one variable.
const std::vector<double>& edges(const ComparisonAxes& axes, transform::Variable variable);

/// The even bins alone.
ComparisonAxes even_axes(const ComparisonAxes& axes);

/// A marginal over the bins of the axes, over the even ones: the same masses. Errors of the parts of
/// a bin are taken to be independent.
transform::Marginal on_even_bins(const ComparisonAxes& axes, transform::Variable variable,
                                 const transform::Marginal& marginal);

}  // namespace fpkcheck::compare
