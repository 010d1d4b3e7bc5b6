#include "backward/generator/collocation.hpp"

#include "numerics/interpolation.hpp"

namespace fpkcheck::backward {

DisplacementSplineSamples sample_displacement_splines(const numerics::SplineBasis& basis,
                                                      int points_per_cell) {
  DisplacementSplineSamples samples;
  for (int s = 0; s < basis.span_count(); ++s) {
    const double begin = basis.breaks()[s], width = basis.breaks()[s + 1] - begin;
    for (const double t : numerics::chebyshev_points(points_per_cell)) {
      samples.y.push_back(begin + t * width);
      samples.span.push_back(s);
      samples.values.push_back(basis.basis_derivatives(samples.y.back(), s, 1));
    }
  }
  return samples;
}

namespace {

double middle(const numerics::Interval& x) { return enclosure_from_interval(x).middle(); }

std::vector<double> bernstein_basis(int n, double t) {
  std::vector<double> b(n + 1, 0.0);
  b[0] = 1;
  for (int m = 1; m <= n; ++m) {
    for (int j = m; j > 0; --j) b[j] = (1 - t) * b[j] + t * b[j - 1];
    b[0] *= 1 - t;
  }
  return b;
}

double sum(std::span<const numerics::Interval> coefficients, const std::vector<double>& basis) {
  double value = 0;
  for (std::size_t j = 0; j < basis.size(); ++j) value += middle(coefficients[j]) * basis[j];
  return value;
}

}  // namespace

VelocityFactorSamples sample_velocity_factors(const VelocityFactorEnclosures& operators,
                                              const ImpactBasis& basis, int points_per_cell) {
  VelocityFactorSamples samples;
  std::vector<Eigen::Triplet<double>> drift, force;
  const std::vector<double> breaks = velocity_breaks(basis);
  std::vector<std::pair<std::size_t, double>> places;  // piece and coordinate t of each point
  std::size_t piece = 0;
  for (std::size_t cell = 0; cell + 1 < breaks.size(); ++cell) {
    for (const double t : numerics::chebyshev_points(points_per_cell)) {
      const double v = breaks[cell] + t * (breaks[cell + 1] - breaks[cell]);
      while (piece + 1 < operators.pieces.size() && middle(operators.pieces[piece].to) < v) ++piece;
      const double from = middle(operators.pieces[piece].from);
      places.emplace_back(piece, (v - from) / (middle(operators.pieces[piece].to) - from));
      samples.v.push_back(v);
    }
  }
  const int points = static_cast<int>(samples.v.size());
  samples.jump.resize(points, basis.size());
  for (int i = 0; i < points; ++i) {
    const auto [at, t] = places[i];
    const std::vector<double> bernstein = bernstein_basis(operators.order() - 1, t);
    for (int b = 0; b < basis.size(); ++b) {
      samples.jump(i, b) = sum(operators.jump.coefficients_of(static_cast<int>(at), b), bernstein);
    }
    for (std::size_t l = 0; l < operators.index[at].size(); ++l) {
      drift.emplace_back(i, operators.index[at][l], sum(operators.drift[at][l], bernstein));
      // adds the term (c_l - c_{l-1}) S_l' of the spline derivative, see VelocityFactorEnclosures
      if (l == 0) continue;
      const double slope = sum(operators.force[at][l - 1], bernstein);
      force.emplace_back(i, operators.index[at][l], slope);
      force.emplace_back(i, operators.index[at][l - 1], -slope);
    }
  }
  samples.drift.resize(points, basis.size());
  samples.drift.setFromTriplets(drift.begin(), drift.end());
  samples.force.resize(points, basis.size());
  samples.force.setFromTriplets(force.begin(), force.end());
  return samples;
}

}  // namespace fpkcheck::backward
