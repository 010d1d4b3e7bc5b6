#include "backward/residual/reconstruction.hpp"

#include <algorithm>
#include <vector>

namespace fpkcheck::backward {
namespace {

constexpr std::ptrdiff_t kStencilEdges = 8;  // stencil of a polynomial of degree 7

/// The slopes at x of the Lagrange polynomials whose nodes are the given cell edges.
std::vector<double> lagrange_slopes(std::span<const double> edges, double x) {
  std::vector<double> slopes;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    double slope = 0;
    for (std::size_t left_out = 0; left_out < edges.size(); ++left_out) {
      if (left_out == a) continue;
      double product = 1 / (edges[a] - edges[left_out]);
      for (std::size_t b = 0; b < edges.size(); ++b) {
        if (b != a && b != left_out) product *= (x - edges[b]) / (edges[a] - edges[b]);
      }
      slope += product;
    }
    slopes.push_back(slope);
  }
  return slopes;
}

}  // namespace

RowMajorSparseMatrix reconstruction_matrix(std::span<const double> edges,
                                           std::span<const double> points) {
  const auto zero = std::ranges::lower_bound(edges, 0.0) - edges.begin();
  const bool has_edge_at_zero =
      zero < std::ssize(edges) && edges[static_cast<std::size_t>(zero)] == 0;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const double x = points[n];
    if (x < edges.front() || x > edges.back()) continue;
    // The cell between edges k - 1 and k, and the edges begin .. end - 1 on its side of 0.
    const auto k = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(edges, x) - edges.begin(), 1,
                                              std::ssize(edges) - 1);
    const std::ptrdiff_t begin = has_edge_at_zero && k > zero ? zero : 0;
    const std::ptrdiff_t end = has_edge_at_zero && k <= zero ? zero + 1 : std::ssize(edges);
    const auto count = std::min(kStencilEdges, end - begin);
    const auto first = std::clamp(k - count / 2, begin, end - count);
    const auto chosen =
        edges.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    const std::vector<double> slopes = lagrange_slopes(chosen, x);
    // The cumulative distribution at an edge contains the masses of all cells before this edge; the
    // slopes of all Lagrange polynomials sum to 0.
    double sum = 0;
    for (auto a = count - 1; a > 0; --a) {
      const auto at = static_cast<std::size_t>(a);
      sum += slopes[at];
      entries.emplace_back(static_cast<int>(n), static_cast<int>(first + a - 1),
                           sum * (chosen[at] - chosen[at - 1]));
    }
  }
  RowMajorSparseMatrix rows(static_cast<Eigen::Index>(points.size()), std::ssize(edges) - 1);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

}  // namespace fpkcheck::backward
