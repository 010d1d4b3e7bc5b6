#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// The bins for the marginals of a problem: uniform bins, of which those at 0 may be divided.
/// Distances use the uniform bins, since no error estimate covers narrower features.
struct ComparisonAxes {
  std::vector<double> y_edges;  ///< increasing; the first edge is the wall, 0, in the paper
  std::vector<double> v_edges;  ///< increasing and symmetric, with 0 among them
  int divisions = 0;            ///< inner edges of the first bin of y and of both bins of y' at 0
};

/// Uniform bins over 0 <= y <= y_s + 7 sigma_1 and |y'| <= 7 sigma_2, with the deviations of
/// equivalent linearisation and the static deflection y_s under the mean of the impulses (0 in the
/// paper). If the marginals are unbounded at rest (problem::impulses_per_decay_time below 1), the
/// bins next to 0 are divided at 1/4, 1/16 and 1/64, so that each part holds some of the mass.
/// Oscillators outside the base class have the ends of problem::scales and no divisions.
/// The bins depend on the problem alone: a simulation can use them for its histogram, which then
/// needs no interpolation.
ComparisonAxes comparison_axes(const problem::Problem& problem);

/// The edges of a variable.
const std::vector<double>& edges(const ComparisonAxes& axes, transform::Variable variable);

/// The axes with undivided bins only.
ComparisonAxes uniform_axes(const ComparisonAxes& axes);

/// Merges the divided bins of a marginal into uniform bins of the same mass. Errors of the merged
/// parts are assumed to be independent.
transform::Marginal merge_divided_bins(const ComparisonAxes& axes, transform::Variable variable,
                                       const transform::Marginal& marginal);

}  // namespace fpkcheck::compare
