#include "backward/residual/unresolved_residual.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "backward/control_variates/generator_factors.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kGaussPointsPerCell = 2;  // number of Gauss points of a cell along one axis

/// Returns the values of a product of functions of y and of v at all pairs of points, shape (y, v).
Eigen::MatrixXd evaluate_on_grid(const SeparableFunction& f, std::span<const double> y,
                                 std::span<const double> v) {
  const auto along = [](const std::function<double(double)>& g, std::span<const double> points) {
    Eigen::VectorXd values(std::ssize(points));
    for (Eigen::Index n = 0; n < values.size(); ++n) {
      values(n) = g(points[static_cast<std::size_t>(n)]);
    }
    return values;
  };
  return along(f.y_factor, y) * along(f.v_factor, v).transpose();
}

/// Returns the weights of a quadrature rule times the values of a weight function.
Eigen::VectorXd weighted_quadrature_weights(const numerics::QuadratureRule& rule,
                                            const std::function<double(double)>& weight) {
  Eigen::VectorXd weights = rule.weights;
  for (Eigen::Index n = 0; n < weights.size(); ++n) {
    weights(n) *= weight(rule.points[static_cast<std::size_t>(n)]);
  }
  return weights;
}

/// Returns the quadrature weights of weighted_quadrature_weights(), divided by their sum.
Eigen::VectorXd normalised_quadrature_weights(const numerics::QuadratureRule& rule,
                                              const std::function<double(double)>& weight) {
  const Eigen::VectorXd weights = weighted_quadrature_weights(rule, weight);
  return weights / weights.sum();
}

/// Returns the positions of the maxima of the potential between neighbouring minima, in increasing
/// order. A position is one of the given points.
std::vector<double> barrier_positions(const problem::Problem& problem,
                                      const std::vector<double>& points) {
  const problem::UndampedOrbits orbits(problem);
  const auto& minima = orbits.potential_minima();
  std::vector<double> barriers;
  for (std::size_t n = 1; n < minima.size(); ++n) {
    double barrier = minima[n];
    for (const double at : points) {
      const bool between = minima[n - 1] < at && at < minima[n];
      if (between && orbits.potential()(at) > orbits.potential()(barrier)) barrier = at;
    }
    barriers.push_back(barrier);
  }
  return barriers;
}

/// Returns the matrix that maps values at the points of y to weighted means over each potential
/// well, shape (wells, points). Each potential well extends from barrier to barrier in y. For a
/// potential with a single well the matrix of means over wells has no rows.
Eigen::MatrixXd well_mean_matrix(const problem::Problem& problem,
                                 const numerics::QuadratureRule& rule,
                                 const std::function<double(double)>& weight) {
  if (problem::problem_features(problem).wells < 2) return {};
  // Fraction of the integral of the fit weight below which a potential well is omitted. With
  // several wells the fit weight decreases faster than the density away from its peak, so that an
  // omitted well has less than 1e-4 of the probability.
  constexpr double kNegligible = 1e-6;
  const std::vector<double> barriers = barrier_positions(problem, rule.points);
  const Eigen::VectorXd weights = weighted_quadrature_weights(rule, weight);
  const auto wells = static_cast<Eigen::Index>(barriers.size()) + 1;
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(wells, weights.size());
  for (Eigen::Index n = 0; n < weights.size(); ++n) {
    const auto well = std::ranges::lower_bound(barriers, rule.points[static_cast<std::size_t>(n)]) -
                      barriers.begin();
    means(well, n) = weights(n);
  }
  Eigen::Index kept = 0;
  for (Eigen::Index well = 0; well < wells; ++well) {
    const double share = means.row(well).sum();
    if (share > kNegligible * weights.sum()) means.row(kept++) = means.row(well) / share;
  }
  means.conservativeResize(kept, Eigen::NoChange);
  return means;
}

}  // namespace

BackwardEquationResiduals::BackwardEquationResiduals(const ControlVariateFitProblem& fit_problem,
                                                     std::span<const SeparableFunction> integrands,
                                                     const ControlVariateFunctions& solutions) {
  const problem::Problem& problem = fit_problem.problem;
  const numerics::QuinticBSplines &ys = fit_problem.y_splines, &vs = fit_problem.v_splines;
  const numerics::QuadratureRule y_rule = numerics::composite_gauss_rule<kGaussPointsPerCell>(
                                     ys.breaks()),
                                 v_rule = numerics::composite_gauss_rule<kGaussPointsPerCell>(
                                     vs.breaks());
  const auto &y = y_rule.points, &v = v_rule.points;
  const GeneratorFactors y_factor = displacement_generator_factors(problem.system, ys, y);
  const GeneratorFactors v_factor = velocity_generator_factors(
      problem, vs, v, spline_means_after_impulse(vs, problem.impulses, v));
  const auto walls = walls_with_restitution(problem.system);
  std::vector<Eigen::MatrixXd> jumps;

  const Eigen::Index ny = std::ssize(y) / kGaussPointsPerCell,
                     nv = std::ssize(v) / kGaussPointsPerCell;
  const auto count = static_cast<Eigen::Index>(integrands.size());
  cell_mean_residuals_.resize(ny * nv, count);
  well_residual_contrasts_ = Eigen::VectorXd::Zero(count);
  const Eigen::MatrixXd well_means = well_mean_matrix(problem, y_rule, fit_problem.y_weight);
  const Eigen::VectorXd v_mean_weights =
      normalised_quadrature_weights(v_rule, fit_problem.v_weight);
  for (const WallWithRestitution& wall : walls) {
    const auto u =
        numerics::composite_gauss_rule<kGaussPointsPerCell>(impact_speed_breaks(vs, wall)).points;
    jumps.push_back(spline_jumps_at_impacts(vs, wall, u));
    wall_mean_jumps_.emplace_back(std::ssize(u) / kGaussPointsPerCell, count);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Eigen::MatrixXd coefficients =
        solutions.spline_coefficients.col(k).reshaped<Eigen::RowMajor>(ys.size(), vs.size());
    Eigen::MatrixXd residual =
        evaluate_on_grid(integrands[at], y, v).array() - solutions.mean_estimates[at];
    for (std::size_t term = 0; term < y_factor.size(); ++term) {
      residual.noalias() += y_factor[term] * coefficients * v_factor[term].transpose();
    }
    if (well_means.rows() > 1) {
      const Eigen::VectorXd means = well_means * (residual * v_mean_weights);
      well_residual_contrasts_(k) = means.maxCoeff() - means.minCoeff();
    }
    for (Eigen::Index i = 0; i < ny; ++i) {
      for (Eigen::Index j = 0; j < nv; ++j) {
        cell_mean_residuals_(i * nv + j, k) =
            residual
                .block<kGaussPointsPerCell, kGaussPointsPerCell>(i * kGaussPointsPerCell,
                                                                 j * kGaussPointsPerCell)
                .cwiseAbs()
                .mean();
      }
    }
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const Eigen::Index row = walls[n].rebound_sign > 0 ? 0 : coefficients.rows() - 1;
      const Eigen::VectorXd jump = jumps[n] * coefficients.row(row).transpose();
      for (Eigen::Index i = 0; i < wall_mean_jumps_[n].rows(); ++i) {
        wall_mean_jumps_[n](i, k) =
            jump.segment<kGaussPointsPerCell>(i * kGaussPointsPerCell).cwiseAbs().mean();
      }
    }
  }
}

Eigen::VectorXd BackwardEquationResiduals::mean_absolute_backward_residuals(
    const DensityIntegrals& density) const {
  const Eigen::VectorXd masses = density.cell_probabilities.reshaped<Eigen::RowMajor>().cwiseAbs();
  Eigen::VectorXd sums = cell_mean_residuals_.transpose() * masses;
  for (std::size_t n = 0; n < wall_mean_jumps_.size(); ++n) {
    sums += wall_mean_jumps_[n].transpose() * density.impact_fluxes[n].cwiseAbs();
  }
  return sums;
}

}  // namespace fpkcheck::backward
