#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/distances.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// A marginal of a solution on the comparison axes.
struct SolutionMarginal {
  std::string solution;  ///< id of the solution
  transform::Variable variable;
  transform::Marginal marginal;
};

/// Distances between the marginals of two solutions; `b` is the more trusted solution. The averages
/// are over smooth bins if either solution is the smooth reference (compare/smooth_reference.hpp)
/// and its partner has no sampling error. Only the L1 distance includes the distance of the rest
/// atoms (compare/rest_atoms.hpp).
struct PairDistances {
  std::string a;
  std::string b;
  transform::Variable variable;
  Distances distances;
  std::optional<double> l1_standard_error = {};  ///< for a distance to the smooth reference
};

/// The distances between two solutions, in either order; null if there are none.
const PairDistances* find_pair(std::span<const PairDistances> pairs, std::string_view first,
                               std::string_view second, transform::Variable variable);

/// The L1 distance between two solutions; empty if there is none or if it is not finite.
std::optional<double> l1_between(std::span<const PairDistances> pairs, std::string_view first,
                                 std::string_view second, transform::Variable variable);

}  // namespace fpkcheck::compare
