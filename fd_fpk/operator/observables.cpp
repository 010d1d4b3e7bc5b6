#include "fd_fpk/operator/observables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fd_fpk/line/line_operators.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_balances.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// factor x^power
problem::Polynomial monomial(int power, double factor = 1) {
  problem::Polynomial::Coefficients a{};
  a[static_cast<std::size_t>(power)] = factor;
  return problem::Polynomial(a);
}

// Integral of a polynomial against the averages of a marginal.
double integral(const Line& line, const Eigen::VectorXd& marginal, int order,
                const problem::Polynomial& weight) {
  return line.widths().dot(weighted_averages(line, weighting_points(order), weight) * marginal);
}

Eigen::VectorXd bell(const Line& line, double deviation) {
  const auto cdf = [&](double x) { return 0.5 * std::erfc(-x / (deviation * std::sqrt(2.0))); };
  Eigen::VectorXd averages(line.cells());
  for (int i = 0; i < line.cells(); ++i) averages(i) = cdf(line.face(i + 1)) - cdf(line.face(i));
  return averages.cwiseQuotient(line.widths());
}

}  // namespace

Marginals marginals(const Grid& grid, const Eigen::VectorXd& averages) {
  // Column i of the map holds the velocity cells at x1 cell i.
  const Eigen::Map<const Eigen::MatrixXd> p(averages.data(), grid.nv(), grid.nx());
  return {p.transpose() * grid.x2.widths(), p * grid.x1.widths()};
}

transform::Moments moments(const Grid& grid, const Eigen::VectorXd& averages, int order) {
  const auto [y, v] = marginals(grid, averages);
  const auto of_y = [&, &y = y](int n) { return integral(grid.x1, y, order, monomial(n)); };
  const auto of_v = [&, &v = v](int n) { return integral(grid.x2, v, order, monomial(n)); };
  return {.y1 = of_y(1), .y2 = of_y(2), .y4 = of_y(4), .v1 = of_v(1), .v2 = of_v(2), .v4 = of_v(4)};
}

double mean_energy(const problem::System& system, const Grid& grid, const Eigen::VectorXd& averages,
                   int order) {
  const auto [y, v] = marginals(grid, averages);
  return integral(grid.x2, v, order, monomial(2, 0.5)) +
         integral(grid.x1, y, order, system.potential());
}

double impact_flux(const Grid& grid, const Eigen::VectorXd& averages, int order, int power) {
  const Eigen::Map<const Eigen::MatrixXd> p(averages.data(), grid.nv(), grid.nx());
  const Eigen::VectorXd wall = p * end_value(grid.x1, order).transpose();
  const auto speed = monomial(power, power % 2 == 0 ? 1 : -1);  // |v|^power for v < 0
  const int half = grid.nv() / 2;
  const LineOperator weighted = weighted_averages(grid.x2, weighting_points(order), speed, half);
  return grid.x2.widths().head(half).dot((weighted * wall).head(half));
}

problem::EnergyTerms energy_terms(const transform::Moments& moments, const Grid& grid,
                                  const Eigen::VectorXd& averages, int order) {
  return {.mean_velocity = moments.v1,
          .mean_square_velocity = moments.v2,
          .impact_energy_flux = impact_flux(grid, averages, order, 3)};
}

double energy_residual(const problem::Problem& problem, problem::Impact impact, const Grid& grid,
                       const Eigen::VectorXd& averages, int order) {
  return problem::energy_residual(
      problem, impact, energy_terms(moments(grid, averages, order), grid, averages, order));
}

transform::BalanceResiduals balance_residuals(const problem::Problem& problem, const Grid& grid,
                                              const Eigen::VectorXd& averages, int order,
                                              double impact_momentum) {
  const auto [y, v] = marginals(grid, averages);
  const auto& force = problem.system.force();
  const auto virial = problem::virial_balance(
      problem, {.mean_displacement = integral(grid.x1, y, order, monomial(1)),
                .mean_square_velocity = integral(grid.x2, v, order, monomial(2)),
                .mean_virial = integral(grid.x1, y, order, force.times_argument())});
  const auto momentum = problem::momentum_balance(
      problem,
      {.mean_force = integral(grid.x1, y, order, force), .impact_momentum = impact_momentum});
  return {.virial = virial.residual(), .momentum = momentum.residual()};
}

WallDensity relative_wall_density(const problem::Problem& problem, const Grid& grid,
                                  const Eigen::VectorXd& averages) {
  const auto linear = problem::equivalent_linearisation(problem);
  // Two half-plane Gaussians at the origin: 2 / (2 pi sigma_1 sigma_2).
  const double gaussian_peak =
      1 / (std::numbers::pi * linear.displacement_deviation * linear.velocity_deviation);
  return wall_density(grid, averages, std::min(gaussian_peak, averages.cwiseAbs().maxCoeff()));
}

Eigen::VectorXd folded_gaussian(const Grid& grid, double displacement_deviation,
                                double velocity_deviation) {
  const Eigen::VectorXd y = bell(grid.x1, displacement_deviation);
  const Eigen::VectorXd v = bell(grid.x2, velocity_deviation);
  Eigen::VectorXd averages(grid.size());
  Eigen::Map<Eigen::MatrixXd>(averages.data(), grid.nv(), grid.nx()) = v * y.transpose();
  return averages / grid.areas().dot(averages);
}

Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  return folded_gaussian(grid, linear.displacement_deviation, linear.velocity_deviation);
}

}  // namespace fpkcheck::fd_fpk
