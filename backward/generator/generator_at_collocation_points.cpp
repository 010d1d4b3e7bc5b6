#include "backward/generator/generator_at_collocation_points.hpp"

#include "numerics/chebyshev_interpolation.hpp"

namespace fpkcheck::backward {

DisplacementSplineSamples sample_displacement_splines(const numerics::SplineBasis& basis,
                                                      int points_per_cell) {
  DisplacementSplineSamples samples;
  for (int s = 0; s < basis.break_span_count(); ++s) {
    const double begin = basis.breaks()[s], width = basis.breaks()[s + 1] - begin;
    for (const double t : numerics::chebyshev_points(points_per_cell)) {
      samples.displacements.push_back(begin + t * width);
      samples.knot_spans.push_back(s);
      samples.values_and_slopes.push_back(
          basis.basis_derivatives(samples.displacements.back(), s, 1));
    }
  }
  return samples;
}

namespace {

double midpoint(const numerics::Interval& x) { return enclosure_from_interval(x).midpoint(); }

// Returns the values at t of all Bernstein polynomials of degree n.
std::vector<double> bernstein_values(int n, double t) {
  std::vector<double> b(n + 1, 0.0);
  b[0] = 1;
  for (int m = 1; m <= n; ++m) {
    for (int j = m; j > 0; --j) b[j] = (1 - t) * b[j] + t * b[j - 1];
    b[0] *= 1 - t;
  }
  return b;
}

// Returns the value at t of a polynomial with interval midpoints as Bernstein coefficients.
double evaluate_polynomial(std::span<const numerics::Interval> coefficients,
                           const std::vector<double>& bernstein) {
  double value = 0;
  for (std::size_t j = 0; j < bernstein.size(); ++j) {
    value += midpoint(coefficients[j]) * bernstein[j];
  }
  return value;
}

}  // namespace

GeneratorVelocityFactorSamples sample_velocity_factors(
    const GeneratorVelocityFactorEnclosures& enclosures, const ImpactSplineBasis& basis,
    int points_per_cell) {
  GeneratorVelocityFactorSamples samples;
  std::vector<Eigen::Triplet<double>> transport, restoring_force;
  const std::vector<double> breaks = basis_break_velocities(basis);
  std::vector<std::pair<std::size_t, double>> positions;  // piece and coordinate t of each point
  std::size_t piece = 0;
  for (std::size_t cell = 0; cell + 1 < breaks.size(); ++cell) {
    for (const double t : numerics::chebyshev_points(points_per_cell)) {
      const double v = breaks[cell] + t * (breaks[cell + 1] - breaks[cell]);
      while (piece + 1 < enclosures.pieces.size() && midpoint(enclosures.pieces[piece].end) < v)
        ++piece;
      const double from = midpoint(enclosures.pieces[piece].begin);
      positions.emplace_back(piece, (v - from) / (midpoint(enclosures.pieces[piece].end) - from));
      samples.velocities.push_back(v);
    }
  }
  const int points = static_cast<int>(samples.velocities.size());
  samples.impulse_and_damping.resize(points, basis.size());
  for (int i = 0; i < points; ++i) {
    const auto [at, t] = positions[i];
    const std::vector<double> bernstein = bernstein_values(enclosures.coefficient_count() - 1, t);
    for (int b = 0; b < basis.size(); ++b) {
      samples.impulse_and_damping(i, b) = evaluate_polynomial(
          enclosures.impulse_and_damping.post_impulse_mean_coefficients(static_cast<int>(at), b),
          bernstein);
    }
    for (std::size_t l = 0; l < enclosures.function_indices[at].size(); ++l) {
      transport.emplace_back(i, enclosures.function_indices[at][l],
                             evaluate_polynomial(enclosures.transport[at][l], bernstein));
      // The entries after the first represent the terms (c_l - c_{l-1}) S_l' of the slope of a
      // spline with coefficients c_l and partial sums S_l.
      if (l == 0) continue;
      const double slope = evaluate_polynomial(enclosures.restoring_force[at][l - 1], bernstein);
      restoring_force.emplace_back(i, enclosures.function_indices[at][l], slope);
      restoring_force.emplace_back(i, enclosures.function_indices[at][l - 1], -slope);
    }
  }
  samples.transport.resize(points, basis.size());
  samples.transport.setFromTriplets(transport.begin(), transport.end());
  samples.restoring_force.resize(points, basis.size());
  samples.restoring_force.setFromTriplets(restoring_force.begin(), restoring_force.end());
  return samples;
}

}  // namespace fpkcheck::backward
