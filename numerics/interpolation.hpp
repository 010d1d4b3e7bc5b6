#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

/// The values at x of the Lagrange polynomials of these nodes: the weights of the values at the
/// nodes in the interpolating polynomial, which is exact for polynomials of a degree below the
/// number of nodes.
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
