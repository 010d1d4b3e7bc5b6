#include "backward/generator/collocation.hpp"

#include <cmath>
#include <numbers>

namespace fpkcheck::backward {

std::vector<double> chebyshev_points(int count) {
  std::vector<double> points(count);
  for (int i = 0; i < count; ++i) {
    points[i] = (1 - std::cos(std::numbers::pi * (2 * i + 1) / (2 * count))) / 2;
  }
  return points;
}

DisplacementSamples displacement_samples(const numerics::SplineBasis& basis, int points_per_cell) {
  DisplacementSamples samples;
  for (int s = 0; s < basis.span_count(); ++s) {
    const double begin = basis.breaks()[s], width = basis.breaks()[s + 1] - begin;
    for (const double t : chebyshev_points(points_per_cell)) {
      samples.y.push_back(begin + t * width);
      samples.span.push_back(s);
      samples.values.push_back(basis.basis_derivatives(samples.y.back(), s, 1));
    }
  }
  return samples;
}

}  // namespace fpkcheck::backward
