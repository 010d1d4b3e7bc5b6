#include "backward/residual/unresolved_residual.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "backward/control/generator_factors.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kGaussPointsPerCell = 2;  // number of points of a cell along an axis

Eigen::MatrixXd values_of(const SeparableFunction& f, std::span<const double> y,
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

Eigen::VectorXd weights_of(const numerics::QuadratureRule& rule,
                           const std::function<double(double)>& weight) {
  Eigen::VectorXd weights = rule.weights;
  for (Eigen::Index n = 0; n < weights.size(); ++n) {
    weights(n) *= weight(rule.points[static_cast<std::size_t>(n)]);
  }
  return weights;
}

Eigen::VectorXd normalised_weights(const numerics::QuadratureRule& rule,
                                   const std::function<double(double)>& weight) {
  const Eigen::VectorXd weights = weights_of(rule, weight);
  return weights / weights.sum();
}

/// Returns the positions of the maxima of the potential V between neighbouring minima, in
/// increasing order.
std::vector<double> barrier_positions(const problem::Problem& problem,
                                      const std::vector<double>& points) {
  const problem::UndampedOrbits orbits(problem);
  const auto& minima = orbits.potential_minima();
  std::vector<double> tops;
  for (std::size_t n = 1; n < minima.size(); ++n) {
    double top = minima[n];
    for (const double at : points) {
      const bool between = minima[n - 1] < at && at < minima[n];
      if (between && orbits.potential()(at) > orbits.potential()(top)) top = at;
    }
    tops.push_back(top);
  }
  return tops;
}

/// Returns the matrix that maps values at the points of y to means over each well, shape (wells,
/// points). Each well extends from barrier to barrier. For a single well the matrix has no rows.
Eigen::MatrixXd well_averages(const problem::Problem& problem, const numerics::QuadratureRule& rule,
                              const std::function<double(double)>& weight) {
  if (problem::problem_features(problem).wells < 2) return {};
  // Fraction of the integral of the fit weight below which a well is omitted. With several wells
  // the fit weight decreases faster than the density away from its peak, so that an omitted well
  // has less than 1e-4 of the mass.
  constexpr double kNegligible = 1e-6;
  const std::vector<double> tops = barrier_positions(problem, rule.points);
  const Eigen::VectorXd weights = weights_of(rule, weight);
  const auto wells = static_cast<Eigen::Index>(tops.size()) + 1;
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(wells, weights.size());
  for (Eigen::Index n = 0; n < weights.size(); ++n) {
    const auto well =
        std::ranges::lower_bound(tops, rule.points[static_cast<std::size_t>(n)]) - tops.begin();
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

UnresolvedResidual::UnresolvedResidual(const ControlFitProblem& fit,
                                       std::span<const SeparableFunction> functions,
                                       const ControlFunctions& h) {
  const problem::Problem& problem = fit.problem;
  const numerics::QuinticBSplines &ys = fit.y, &vs = fit.v;
  const numerics::QuadratureRule in_y = numerics::composite_gauss_rule<kGaussPointsPerCell>(
                                     ys.breaks()),
                                 in_v = numerics::composite_gauss_rule<kGaussPointsPerCell>(
                                     vs.breaks());
  const auto &y = in_y.points, &v = in_v.points;
  const GeneratorFactors y_factor = displacement_generator_factors(problem.system, ys, y);
  const GeneratorFactors v_factor = velocity_generator_factors(
      problem, vs, v, spline_means_after_impulse(vs, problem.impulses, v));
  const auto walls = impact_walls(problem.system);
  std::vector<Eigen::MatrixXd> jumps;

  const Eigen::Index ny = std::ssize(y) / kGaussPointsPerCell,
                     nv = std::ssize(v) / kGaussPointsPerCell;
  const auto count = static_cast<Eigen::Index>(functions.size());
  in_cells_.resize(ny * nv, count);
  well_contrasts_ = Eigen::VectorXd::Zero(count);
  const Eigen::MatrixXd in_wells = well_averages(problem, in_y, fit.weight_y);
  const Eigen::VectorXd over_v = normalised_weights(in_v, fit.weight_v);
  for (const ImpactWall& wall : walls) {
    const auto u =
        numerics::composite_gauss_rule<kGaussPointsPerCell>(non_smooth_impact_speeds(vs, wall))
            .points;
    jumps.push_back(spline_jumps_at_impacts(vs, wall, u));
    at_walls_.emplace_back(std::ssize(u) / kGaussPointsPerCell, count);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Eigen::MatrixXd coefficients =
        h.coefficients.col(k).reshaped<Eigen::RowMajor>(ys.size(), vs.size());
    Eigen::MatrixXd residual = values_of(functions[at], y, v).array() - h.means[at];
    for (std::size_t term = 0; term < y_factor.size(); ++term) {
      residual.noalias() += y_factor[term] * coefficients * v_factor[term].transpose();
    }
    if (in_wells.rows() > 1) {
      const Eigen::VectorXd means = in_wells * (residual * over_v);
      well_contrasts_(k) = means.maxCoeff() - means.minCoeff();
    }
    for (Eigen::Index i = 0; i < ny; ++i) {
      for (Eigen::Index j = 0; j < nv; ++j) {
        in_cells_(i * nv + j, k) = residual
                                       .block<kGaussPointsPerCell, kGaussPointsPerCell>(
                                           i * kGaussPointsPerCell, j * kGaussPointsPerCell)
                                       .cwiseAbs()
                                       .mean();
      }
    }
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const Eigen::Index row = walls[n].rebound_sign > 0 ? 0 : coefficients.rows() - 1;
      const Eigen::VectorXd jump = jumps[n] * coefficients.row(row).transpose();
      for (Eigen::Index i = 0; i < at_walls_[n].rows(); ++i) {
        at_walls_[n](i, k) =
            jump.segment<kGaussPointsPerCell>(i * kGaussPointsPerCell).cwiseAbs().mean();
      }
    }
  }
}

Eigen::VectorXd UnresolvedResidual::mean_residuals(const DensityIntegrals& density) const {
  const Eigen::VectorXd masses = density.cells.reshaped<Eigen::RowMajor>().cwiseAbs();
  Eigen::VectorXd sums = in_cells_.transpose() * masses;
  for (std::size_t n = 0; n < at_walls_.size(); ++n) {
    sums += at_walls_[n].transpose() * density.impacts[n].cwiseAbs();
  }
  return sums;
}

}  // namespace fpkcheck::backward
