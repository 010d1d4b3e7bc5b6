#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

/// Returns the weights of the function values at the nodes in the interpolating polynomial at x,
/// that is, the Lagrange basis polynomials at x.
/// @param nodes distinct numbers
inline std::vector<double> lagrange_weights(std::span<const double> nodes, double x) {
  std::vector<double> weights;
  weights.reserve(nodes.size());
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    double weight = 1;
    for (std::size_t b = 0; b < nodes.size(); ++b) {
      if (b != a) weight *= (x - nodes[b]) / (nodes[a] - nodes[b]);
    }
    weights.push_back(weight);
  }
  return weights;
}

}  // namespace fpkcheck::numerics
