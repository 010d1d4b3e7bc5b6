#include "fd_fpk/observables.hpp"

#include <cmath>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Integral of x^power against the averages of a marginal.
double moment(const UniformLine& line, const Eigen::VectorXd& marginal, int order, int power) {
  Polynomial weight(power + 1, 0.0);
  weight[power] = 1;
  return (weighted_averages(line, weighting_points(order), weight) * marginal).sum() * line.step;
}

Eigen::VectorXd bell(const UniformLine& line, double deviation) {
  const auto cdf = [&](double x) { return 0.5 * std::erfc(-x / (deviation * std::sqrt(2.0))); };
  Eigen::VectorXd averages(line.cells);
  for (int i = 0; i < line.cells; ++i) averages(i) = cdf(line.face(i + 1)) - cdf(line.face(i));
  return averages / line.step;
}

}  // namespace

transform::Moments moments(const Grid& grid, const Eigen::VectorXd& averages, int order) {
  // Column i of the map holds the velocity cells at x1 cell i.
  const Eigen::Map<const Eigen::MatrixXd> p(averages.data(), grid.nv, grid.nx);
  const Eigen::VectorXd y = p.colwise().sum().transpose() * grid.x2().step;
  const Eigen::VectorXd v = p.rowwise().sum() * grid.x1().step;
  const auto of_y = [&](int power) { return moment(grid.x1(), y, order, power); };
  const auto of_v = [&](int power) { return moment(grid.x2(), v, order, power); };
  return {.y1 = of_y(1), .y2 = of_y(2), .y4 = of_y(4), .v1 = of_v(1), .v2 = of_v(2), .v4 = of_v(4)};
}

double impact_flux(const Grid& grid, const Eigen::VectorXd& averages, int order, int power) {
  const Eigen::Map<const Eigen::MatrixXd> p(averages.data(), grid.nv, grid.nx);
  const Eigen::VectorXd wall = p * end_value(grid.x1(), order).transpose();
  Polynomial weight(power + 1, 0.0);
  weight[power] = power % 2 == 0 ? 1 : -1;  // |v|^power for v < 0
  const int half = grid.nv / 2;
  const LineOperator weighted = weighted_averages(grid.x2(), weighting_points(order), weight, half);
  return (weighted * wall).head(half).sum() * grid.x2().step;
}

Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  const Eigen::VectorXd y = bell(grid.x1(), linear.displacement_deviation);
  const Eigen::VectorXd v = bell(grid.x2(), linear.velocity_deviation);
  Eigen::VectorXd averages(grid.size());
  Eigen::Map<Eigen::MatrixXd>(averages.data(), grid.nv, grid.nx) = v * y.transpose();
  return averages / (averages.sum() * grid.cell_area());
}

}  // namespace fpkcheck::fd_fpk
