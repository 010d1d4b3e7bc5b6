#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <variant>

#include "exact/closed_forms.hpp"
#include "fd_fpk/options.hpp"
#include "problem/undamped_orbits.hpp"
#include "transform/solution.hpp"

/// White noise and an elastic impact, with a known density: for a test and a benchmark.
namespace fpkcheck::tests {

/// Options for the null vector on nx x nv cells. The walls of the box have equal energy, at 5.5
/// standard deviations of the velocity from rest.
inline fd_fpk::FiniteVolumeOptions elastic_white_noise_exponent(const problem::Problem& p,
                                                                int order, int nx, int nv) {
  constexpr double kDeviations = 5.5;
  const double v2 = exact::mean_square_velocity(p) * kDeviations * kDeviations;
  return {.equation = problem::DensityEquation::white,
          .stepper = fd_fpk::StationarySolver::direct,
          .order = order,
          .nx = nx,
          .nv = nv,
          .x1_max = problem::UndampedOrbits(p).half_cycles(v2 / 2).back().right,
          .x2_max = std::sqrt(v2),
          .error_estimate = false};
}

/// Integrals of |bin average - exact bin average| over the cells of the solution.
struct MarginalErrors {
  double y, v;
};
inline MarginalErrors errors_of(const transform::Solution& solution, const problem::Problem& p) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  const auto l1_distance = [](const transform::Marginal& marginal, const auto& exact) {
    double sum = 0;
    for (std::size_t b = 0; b < marginal.size(); ++b) {
      sum += std::abs(marginal.density[b] * marginal.bin_width(b) -
                      Rule::integrate(exact, marginal.edges[b], marginal.edges[b + 1]));
    }
    return sum;
  };
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const exact::WhiteNoiseDensity exact(p);
  return {l1_distance(marginal(solution, transform::StateVariable::y, grid.y_edges),
                      [&](double y) { return exact.displacement_marginal(y); }),
          l1_distance(marginal(solution, transform::StateVariable::ydot, grid.v_edges),
                      [&](double v) { return exact.velocity_marginal(v); })};
}

}  // namespace fpkcheck::tests
