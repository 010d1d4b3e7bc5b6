#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/distances.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::compare {

/// A marginal density of a solution, averaged over the comparison bins.
struct SolutionMarginalDensity {
  std::string solution;
  transform::StateVariable variable;
  transform::Marginal marginal;
};

/// Distances between the marginal densities of two solutions in one variable, y or y'. The
/// distances between two solutions are over smooth bins if one is the smooth reference
/// (compare/smooth_reference.hpp) and the other has no sampling error. Only the L1 distance between
/// two solutions includes the difference of their probabilities of rest (compare/rest_atoms.hpp).
struct SolutionPairDistances {
  std::string a;
  std::string b;  ///< id of the more trusted of the two solutions
  transform::StateVariable variable;
  DensityDistances distances;
  /// Standard error of the L1 distance over smooth bins; empty for a distance over uniform bins.
  std::optional<double> l1_standard_error = {};
};

/// Returns the distances between two solutions in one variable; the order of the two ids does not
/// matter. The result is null if the list `pairs` lacks the distances between the two solutions.
const SolutionPairDistances* find_pair_distances(std::span<const SolutionPairDistances> pairs,
                                                 std::string_view first, std::string_view second,
                                                 transform::StateVariable variable);

/// Returns the L1 distance between two solutions; empty if the distance is missing or not finite.
std::optional<double> l1_distance_between(std::span<const SolutionPairDistances> pairs,
                                          std::string_view first, std::string_view second,
                                          transform::StateVariable variable);

}  // namespace fpkcheck::compare
