#include "backward/residual/weak_residuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "backward/control_variates/generator_factors.hpp"
#include "base/input_error.hpp"
#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {
namespace {

constexpr std::size_t kNodesPerCell = 8;  // number of Gauss points between consecutive breaks of v
constexpr int kPowers = 5;                // number of powers of a coordinate, 0 .. 4
// Smallest distance between two breaks of the velocity, relative to the range of v. Closer breaks
// differ only by rounding.
constexpr double kMinBreakDistance = 1e-12;

std::vector<double> gauss_nodes(const std::vector<double>& breaks) {
  auto nodes = numerics::composite_gauss_rule<kNodesPerCell>(breaks).points;
  std::ranges::sort(nodes);
  return nodes;
}

/// Returns the breaks of the splines B_j and of their means K B_j after an impulse. Each atom of
/// the amplitude law, and each corner of its density, shifts the multiple knots of the splines,
/// where the splines have discontinuous derivatives.
std::vector<double> breaks_after_impulse(const numerics::QuinticBSplines& v,
                                         const problem::ImpulseTrain& impulses) {
  std::vector<double> amplitudes;
  if (impulses.is_acting()) {
    amplitudes = impulses.amplitude_law().amplitude_density_breakpoints();
    for (const auto& atom : impulses.amplitude_law().amplitude_atoms())
      amplitudes.push_back(atom.amplitude);
  }
  std::vector<double> breaks(v.breaks());
  const auto& knots = v.knots();
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (knots[k] != knots[k - 1] || knots[k] == v.begin() || knots[k] == v.end()) continue;
    for (const double amplitude : amplitudes) breaks.push_back(knots[k] - amplitude);
  }
  std::erase_if(breaks, [&](double x) { return x < v.begin() || x > v.end(); });
  std::ranges::sort(breaks);
  const double least = kMinBreakDistance * (v.end() - v.begin());
  breaks.erase(
      std::unique(breaks.begin(), breaks.end(), [=](double a, double b) { return b - a < least; }),
      breaks.end());
  return breaks;
}

std::vector<ImpactSpeedBreakpoints> find_impact_breaks(
    const std::vector<WallWithRestitution>& walls, const numerics::QuinticBSplines& v) {
  std::vector<ImpactSpeedBreakpoints> all;
  for (const WallWithRestitution& wall : walls) {
    all.push_back({wall.position, wall.rebound_sign, impact_speed_breaks(v, wall)});
  }
  return all;
}

/// Returns the powers 1, x, .., x^4 of a coordinate x at points, shape (points, 5).
template <class Coordinate>
Eigen::MatrixXd coordinate_powers(std::span<const double> points, const Coordinate& coordinate) {
  Eigen::MatrixXd powers(std::ssize(points), kPowers);
  Eigen::VectorXd x(std::ssize(points));
  for (Eigen::Index n = 0; n < x.size(); ++n) {
    x(n) = coordinate(points[static_cast<std::size_t>(n)]);
  }
  powers.col(0).setOnes();
  for (int n = 1; n < kPowers; ++n) powers.col(n) = powers.col(n - 1).cwiseProduct(x);
  return powers;
}

/// Returns the indicator functions of the cells between consecutive breaks at points, shape
/// (points, breaks - 1).
Eigen::MatrixXd cell_indicators(std::span<const double> points, const std::vector<double>& breaks) {
  Eigen::MatrixXd one = Eigen::MatrixXd::Zero(std::ssize(points), std::ssize(breaks) - 1);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto after = std::ranges::upper_bound(breaks, points[n]) - breaks.begin();
    one(static_cast<Eigen::Index>(n), std::clamp<Eigen::Index>(after - 1, 0, one.cols() - 1)) = 1;
  }
  return one;
}

}  // namespace

WeakResidualIntegrator::WeakResidualIntegrator(const problem::Problem& problem,
                                               ControlVariateSplines splines)
    : problem_(problem),
      y_splines_(std::move(splines.y_splines)),
      v_splines_(std::move(splines.v_splines)),
      walls_(walls_with_restitution(problem.system)),
      impact_breaks_(find_impact_breaks(walls_, v_splines_)),
      v_breaks_(breaks_after_impulse(v_splines_, problem.impulses)),
      gauss_velocities_(gauss_nodes(v_breaks_)),
      means_at_gauss_velocities_(
          spline_means_after_impulse(v_splines_, problem.impulses, gauss_velocities_)) {}

/// Returns the means K B_j of the splines B_j after an impulse, interpolated between the Gauss
/// points of a cell, where the mean K B_j is smooth. Beyond the ends of the splines the mean K B_j
/// after an impulse is constant.
Eigen::MatrixXd WeakResidualIntegrator::interpolate_means_after_impulse(
    std::span<const double> v) const {
  if (!problem_.impulses.is_acting()) return {};
  Eigen::MatrixXd result(std::ssize(v), v_splines_.size());
  const auto& breaks = v_breaks_;
  for (std::size_t n = 0; n < v.size(); ++n) {
    const double x = std::clamp(v[n], v_splines_.begin(), v_splines_.end());
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
    const auto first = static_cast<std::size_t>(after - breaks.begin() - 1) * kNodesPerCell;
    const std::span<const double, kNodesPerCell> nodes(gauss_velocities_.data() + first,
                                                       kNodesPerCell);
    const std::vector<double> lagrange = numerics::lagrange_weights(nodes, x);
    result.row(static_cast<Eigen::Index>(n)).noalias() =
        Eigen::Map<const Eigen::RowVectorXd>(lagrange.data(), kNodesPerCell) *
        means_at_gauss_velocities_.middleRows(static_cast<Eigen::Index>(first),
                                              static_cast<Eigen::Index>(kNodesPerCell));
  }
  return result;
}

/// Returns the integrals over the impacts at a wall, int u p(0, -u) [B_j(r u) - B_j(-u)] du, for
/// all splines B_j, mirrored at a right wall.
Eigen::RowVectorXd WeakResidualIntegrator::integrate_impact_terms(
    const WallWithRestitution& wall, const SampledWallDensity& wall_density) const {
  const auto& speeds = wall_density.speed_quadrature.points;
  const Eigen::Map<const Eigen::VectorXd> u(speeds.data(), std::ssize(speeds));
  const Eigen::MatrixXd jumps = spline_jumps_at_impacts(v_splines_, wall, speeds);
  return (wall_density.speed_quadrature.integrals_of_functions_times_density(u.asDiagonal() *
                                                                             jumps) *
          wall_density.samples)
      .transpose();
}

DensityIntegrals WeakResidualIntegrator::integrate_density(
    const transform::Density& density) const {
  const SampledDensity p = sample_density(
      density,
      {.y_breaks = y_splines_.breaks(), .v_breaks = v_breaks_, .impact_breaks = impact_breaks_});

  // Moments E_p[y^m y'^n] of a density in physical coordinates, before normalisation.
  const problem::WallFrame& frame = problem_.frame;
  const Eigen::MatrixXd along_y =
      p.y_quadrature.integrals_of_functions_times_density(
          coordinate_powers(p.y_quadrature.points, [&](double x) { return frame.physical_y(x); })) *
      p.samples;
  const Eigen::MatrixXd along_v =
      p.v_quadrature.integrals_of_functions_times_density(coordinate_powers(
          p.v_quadrature.points, [&](double x) { return frame.physical_velocity(x); }));
  const Eigen::MatrixXd powers = along_y * along_v.transpose();
  const double mass = powers(0, 0);
  if (!(mass > 0) || !std::isfinite(mass)) {
    throw InputError(fmt::format("no residuals: the mass {:.4g} is not positive", mass));
  }
  const auto moment = [&](int m, int n) { return powers(m, n) / mass; };

  const GeneratorFactors y =
      displacement_generator_factors(problem_.system, y_splines_, p.y_quadrature.points);
  const GeneratorFactors v =
      velocity_generator_factors(problem_, v_splines_, p.v_quadrature.points,
                                 interpolate_means_after_impulse(p.v_quadrature.points));
  // All factors in y have a small support. The means K B_j of the splines after an impulse, part of
  // a factor in v of the generator, are nonzero on a large interval.
  const auto integrated_over_y = [&](const Eigen::MatrixXd& functions) -> Eigen::MatrixXd {
    return p.y_quadrature.sparse_integrals_times_density(functions) * p.samples;
  };
  Eigen::MatrixXd residuals = Eigen::MatrixXd::Zero(y_splines_.size(), v_splines_.size());
  for (std::size_t term = 0; term < y.size(); ++term) {
    residuals.noalias() += integrated_over_y(y[term]) *
                           p.v_quadrature.integrals_of_functions_times_density(v[term]).transpose();
  }
  std::vector<Eigen::VectorXd> impact_fluxes;
  for (std::size_t n = 0; n < walls_.size(); ++n) {
    // At the left wall the first spline of y has the value 1, at the right wall the last spline of
    // y. All splines of y other than the first or the last are 0 at the wall.
    residuals.row(walls_[n].rebound_sign > 0 ? 0 : y_splines_.size() - 1) +=
        integrate_impact_terms(walls_[n], p.wall_densities[n]);
    const DensityAxisQuadrature& speeds = p.wall_densities[n].speed_quadrature;
    const Eigen::Map<const Eigen::VectorXd> u(speeds.points.data(), std::ssize(speeds.points));
    const Eigen::MatrixXd flux =
        u.asDiagonal() * cell_indicators(speeds.points, impact_breaks_[n].breaks);
    impact_fluxes.push_back(speeds.integrals_of_functions_times_density(flux) *
                            p.wall_densities[n].samples / mass);
  }
  const Eigen::MatrixXd cells =
      integrated_over_y(cell_indicators(p.y_quadrature.points, y_splines_.breaks())) *
      p.v_quadrature
          .sparse_integrals_times_density(
              cell_indicators(p.v_quadrature.points, v_splines_.breaks()))
          .transpose();
  const Eigen::MatrixXd means =
      integrated_over_y(evaluate_splines(y_splines_, p.y_quadrature.points).values) *
      p.v_quadrature
          .sparse_integrals_times_density(
              evaluate_splines(v_splines_, p.v_quadrature.points).values)
          .transpose();
  return {.mass = mass,
          .moments = {.y1 = moment(1, 0),
                      .y2 = moment(2, 0),
                      .y4 = moment(4, 0),
                      .v1 = moment(0, 1),
                      .v2 = moment(0, 2),
                      .v4 = moment(0, 4)},
          .spline_means = means / mass,
          .weak_residuals = residuals / mass,
          .cell_probabilities = cells / mass,
          .impact_fluxes = std::move(impact_fluxes)};
}

}  // namespace fpkcheck::backward
