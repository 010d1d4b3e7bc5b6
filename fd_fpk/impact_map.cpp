#include "fd_fpk/impact_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// Adds `sign` times the weights of the face values G_0 .. G_cells in G(u), u in units of the step.
void add_interpolation(double u, int cells, int order, double sign, std::vector<double>& row) {
  if (u >= cells) {
    row[cells] += sign;  // everything below u has been counted
    return;
  }
  const int points = std::min(order + 1, cells + 1);
  const int first =
      std::clamp(static_cast<int>(std::floor(u)) - (points - 1) / 2, 0, cells + 1 - points);
  for (int a = first; a < first + points; ++a) {
    double weight = 1;
    for (int b = first; b < first + points; ++b) {
      if (b != a) weight *= (u - b) / (a - b);
    }
    row[a] += sign * weight;
  }
}

}  // namespace

LineOperator impact_map(int cells, double restitution, int order) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int a = 0; a < cells; ++a) {
    std::vector<double> faces(cells + 1, 0.0);  // the row in terms of G_0 .. G_cells
    // The last cell takes all that is faster, so that the differences telescope to G_cells - G_0.
    add_interpolation(a + 1 == cells ? cells : (a + 1) / restitution, cells, order, 1.0, faces);
    add_interpolation(a / restitution, cells, order, -1.0, faces);
    // G_f = sum_{b < f} f_b: the weight of f_b is the sum over the faces above it.
    double weight = 0;
    for (int b = cells - 1; b >= 0; --b) {
      weight += faces[b + 1];
      if (std::abs(weight) > 1e-15) entries.emplace_back(a, b, weight);
    }
  }
  LineOperator matrix(cells, cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace fpkcheck::fd_fpk
