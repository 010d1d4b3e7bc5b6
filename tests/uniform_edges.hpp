#pragma once

#include <vector>

namespace fpkcheck::tests {

/// Edges of n equal cells from a to b.
inline std::vector<double> uniform_edges(double a, double b, int n) {
  std::vector<double> edges;
  for (int k = 0; k <= n; ++k) edges.push_back(a + (b - a) * k / n);
  return edges;
}

}  // namespace fpkcheck::tests
