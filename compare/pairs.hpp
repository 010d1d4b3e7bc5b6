#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/distances.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// A marginal of one solution on the comparison axes.
struct SolutionMarginal {
  std::string solution;  ///< id
  transform::Variable variable;
  transform::Marginal marginal;
};

/// Distances between one marginal of two solutions; `b` is the more trusted of them. Where one of
/// them is the smooth measure (compare/smooth.hpp), and the other has no errors by chance of its
/// own, they are those of averages over smooth bins. The L1 distance has that of atoms of rest added
/// (compare/rest_atoms.hpp); the others are of the densities alone.
struct PairDistances {
  std::string a;
  std::string b;
  transform::Variable variable;
  Distances distances;
  std::optional<double> l1_standard_error = {};  ///< of a distance to the smooth measure
};

/// The pair of two solutions, whichever of them is the more trusted; null when there is none.
const PairDistances* find_pair(std::span<const PairDistances> pairs, std::string_view one,
                               std::string_view other, transform::Variable variable);

/// Their L1 distance; nothing where there is none, or where it is not a number.
std::optional<double> l1_between(std::span<const PairDistances> pairs, std::string_view one,
                                 std::string_view other, transform::Variable variable);

}  // namespace fpkcheck::compare
