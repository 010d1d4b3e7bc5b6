#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/distances.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// A marginal density of a solution on the comparison axes.
struct SolutionMarginal {
  std::string solution;  ///< id of the solution
  transform::Variable variable;
  transform::Marginal marginal;
};

/// Distances between the marginals of two solutions in one variable. The distances are over smooth
/// bins if one of the two solutions is the smooth reference (compare/smooth_reference.hpp) and the
/// other solution has no sampling error. The L1 distance, but no other distance, includes the
/// distance of the rest atoms (compare/rest_atoms.hpp).
struct PairDistances {
  std::string a;  ///< id of the less trusted solution
  std::string b;  ///< id of the more trusted solution
  transform::Variable variable;
  Distances distances;
  /// Standard error of the L1 distance, if the distances are over smooth bins; else empty.
  std::optional<double> l1_standard_error = {};
};

/// The distances between two solutions, given in either order; null if there are none.
const PairDistances* find_pair_distances(std::span<const PairDistances> pairs,
                                         std::string_view first, std::string_view second,
                                         transform::Variable variable);

/// The L1 distance between two solutions; empty if the distance is missing or not finite.
std::optional<double> l1_distance_between(std::span<const PairDistances> pairs,
                                          std::string_view first, std::string_view second,
                                          transform::Variable variable);

}  // namespace fpkcheck::compare
