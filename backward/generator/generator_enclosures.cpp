#include "backward/generator/generator_enclosures.hpp"

#include <algorithm>
#include <cassert>
#include <cfenv>

#include "backward/generator/impact_basis.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

GeneratorVelocityFactorEnclosures enclose_velocity_factors(const problem::Problem& problem,
                                                           const ImpactSplineBasis& basis,
                                                           std::span<const double> cuts) {
  assert(std::fegetround() == FE_UPWARD);
  const problem::ImpulseLaw& law = problem.impulses.amplitude_law();
  VelocityPieceConstraints constraints = velocity_piece_constraints(basis, law);
  constraints.break_velocities.insert(constraints.break_velocities.end(), cuts.begin(), cuts.end());
  std::sort(constraints.break_velocities.begin(), constraints.break_velocities.end());

  GeneratorVelocityFactorEnclosures enclosures;
  enclosures.pieces =
      divide_velocity_axis(basis, constraints.break_velocities, constraints.max_length);
  enclosures.impulse_and_damping = compute_impulse_mean_table(basis, enclosures.pieces, law);
  const numerics::Interval rate = problem.impulses.arrival_rate(),
                           damping = problem.system.damping();
  PostImpulseMeanTable& jump = enclosures.impulse_and_damping;
  const int degree = jump.coefficient_count - 1;
  for (numerics::Interval& c : jump.coefficients) c *= rate;
  jump.remainder_bound = (rate * jump.remainder_bound).upper();
  for (std::size_t i = 0; i < enclosures.pieces.size(); ++i) {
    const VelocityAxisPiece& piece = enclosures.pieces[i];
    const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, piece);
    const numerics::BernsteinCoefficients v{piece.begin, piece.end};
    const numerics::Interval length = piece.length();
    enclosures.function_indices.push_back(functions.indices);
    enclosures.transport.emplace_back();
    enclosures.restoring_force.emplace_back();
    for (std::size_t l = 0; l < functions.indices.size(); ++l) {
      const numerics::BernsteinCoefficients& b = functions.polynomials[l];
      numerics::BernsteinCoefficients slope = bernstein_derivative(b);
      for (numerics::Interval& s : slope) s /= length;
      const numerics::BernsteinCoefficients value = elevate_bernstein_degree(b, degree);
      const numerics::BernsteinCoefficients damped =
          elevate_bernstein_degree(bernstein_product(v, slope), degree);
      const std::span<numerics::Interval> out =
          jump.post_impulse_mean_coefficients(static_cast<int>(i), functions.indices[l]);
      for (int j = 0; j <= degree; ++j) out[j] -= rate * value[j] + damping * damped[j];
      enclosures.transport.back().push_back(
          elevate_bernstein_degree(bernstein_product(v, b), degree));
    }
    for (const numerics::BernsteinCoefficients& slope :
         enclose_slopes_of_basis_partial_sums(basis, piece)) {
      numerics::BernsteinCoefficients force = elevate_bernstein_degree(slope, degree);
      for (numerics::Interval& s : force) s = -s;
      enclosures.restoring_force.back().push_back(std::move(force));
    }
  }
  return enclosures;
}

GeneratorDisplacementFactorEnclosures enclose_displacement_factors(
    const problem::Problem& problem, const numerics::SplineBasis& basis,
    std::span<const double> cuts) {
  const problem::SystemCoefficients& c = problem.system.coefficients();
  const int degree = basis.degree() + 3;
  GeneratorDisplacementFactorEnclosures enclosures;
  for (int span = 0; span < basis.break_span_count(); ++span) {
    std::vector<double> points{basis.breaks()[span]};
    for (const double cut : cuts) {
      if (cut > points.back() && cut < basis.breaks()[span + 1]) points.push_back(cut);
    }
    points.push_back(basis.breaks()[span + 1]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const numerics::Interval from = points[i], to = points[i + 1];
      enclosures.pieces.push_back({span, points[i], points[i + 1]});
      auto& factors = enclosures.factors.emplace_back();
      const auto rows = numerics::bezier_extraction<numerics::Interval>(basis, span, from, to);
      const numerics::BernsteinCoefficients force = bernstein_coefficients_on_segment(
          std::array{0.0, c.stiffness, 0.0, c.cubic}, numerics::Interval(0), from, to);
      for (int l = 0; l < rows.rows(); ++l) {
        const numerics::BernsteinCoefficients value(rows.row(l).begin(), rows.row(l).end());
        factors[0].push_back(elevate_bernstein_degree(value, degree));
        factors[2].push_back(bernstein_product(force, value));
      }
      for (const numerics::BernsteinCoefficients& slope :
           enclose_slopes_of_basis_partial_sums(basis, span, from, to)) {
        factors[1].push_back(elevate_bernstein_degree(slope, degree));
      }
    }
  }
  return enclosures;
}

}  // namespace fpkcheck::backward
