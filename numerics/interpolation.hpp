#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

/// Returns the zeros of the Chebyshev polynomial of degree `count`, shifted to (0, 1), in
/// increasing order.
inline std::vector<double> chebyshev_points(int count) {
  std::vector<double> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    points.push_back((1 - std::cos(std::numbers::pi * (2 * i + 1) / (2 * count))) / 2);
  }
  return points;
}

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
