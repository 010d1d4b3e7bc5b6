#pragma once

#include <algorithm>
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

/// Returns the weights of the function values at the interpolation nodes in the value of the
/// interpolating polynomial at x, that is, the Lagrange basis polynomials at x.
/// @param nodes distinct interpolation nodes
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

/// Returns the weights of the function values at the nodes in the derivative of the given order of
/// the interpolating polynomial at x (Fornberg, Mathematics of Computation 51 (1988) 699).
/// @param nodes distinct interpolation nodes, more than `order`
inline std::vector<double> lagrange_derivative_weights(std::span<const double> nodes, double x,
                                                       int order) {
  const auto m = static_cast<std::size_t>(order);
  // Element (k, a) is the weight of node a in derivative k of the polynomial through the first
  // nodes.
  std::vector<std::vector<double>> weights(m + 1, std::vector<double>(nodes.size()));
  weights[0][0] = 1;
  double product = 1;  // of the differences between the last node and the nodes before it
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    double next_product = 1;
    for (std::size_t a = 0; a < n; ++a) {
      const double distance = nodes[n] - nodes[a];
      next_product *= distance;
      for (std::size_t k = std::min(n, m) + 1; k-- > 0;) {
        const double lower = k > 0 ? static_cast<double>(k) * weights[k - 1][a] : 0;
        if (a + 1 == n) {
          weights[k][n] = product / next_product * (lower - (nodes[n - 1] - x) * weights[k][n - 1]);
        }
        weights[k][a] = ((nodes[n] - x) * weights[k][a] - lower) / distance;
      }
    }
    product = next_product;
  }
  return weights[m];
}

}  // namespace fpkcheck::numerics
