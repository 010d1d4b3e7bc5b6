#include "epc/moment/energy_domain.hpp"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::moment {

Line legendre_rule(int points, double a, double b) {
  std::vector<double> nodes;
  for (const double zero : boost::math::legendre_p_zeros<double>(points)) {
    if (zero > 0) nodes.push_back(-zero);
    nodes.push_back(zero);
  }
  std::ranges::sort(nodes);
  Line line{Eigen::VectorXd(points), Eigen::VectorXd(points)};
  for (int i = 0; i < points; ++i) {
    const double x = nodes[i];
    const double slope = boost::math::legendre_p_prime(points, x);
    line.at[i] = (a + b) / 2 + (b - a) / 2 * x;
    line.weight[i] = (b - a) / ((1 - x * x) * slope * slope);
  }
  return line;
}

EnergyDomain::EnergyDomain(const problem::Problem& problem, double level)
    : stiffness_(problem.system.stiffness()),
      cubic_(problem.system.cubic()),
      mean_force_(problem.impulses.rate_moment(1)),
      level_(level),
      minimum_(problem::static_deflection(problem)),
      least_(potential(minimum_)) {
  double beyond = minimum_ + 1;
  while (energy(beyond, 0) < level_) beyond = minimum_ + 2 * (beyond - minimum_);
  y_high_ = turning_point(minimum_, beyond);
  y_low_ = energy(0, 0) <= level_ ? 0 : turning_point(minimum_, 0);
}

double EnergyDomain::potential(double y) const {
  return y * y * (stiffness_ / 2 + cubic_ * y * y / 4) - mean_force_ * y;
}

double EnergyDomain::turning_point(double from, double towards) const {
  const auto excess = [this](double y) { return energy(y, 0) - level_; };
  const auto [low, high] = std::minmax(from, towards);
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(), iterations);
  return (bracket.first + bracket.second) / 2;
}

double EnergyDomain::half_width(double y) const {
  return std::sqrt(std::max(0.0, 2 * (level_ - energy(y, 0))));
}

double EnergyDomain::v_max() const { return std::sqrt(2 * level_); }

Points EnergyDomain::rule(int y_points, int v_points) const {
  // With the wall inside, sin(phi) = -1 would be the left turning point if V were even about its
  // minimum; where even that lies inside, the wall itself is the left end.
  const bool cut_by_wall = y_low_ == 0 && minimum_ < y_high_ - minimum_;
  const double centre = cut_by_wall ? minimum_ : (y_low_ + y_high_) / 2;
  const double reach = y_high_ - centre;
  const double first = cut_by_wall ? std::asin(-centre / reach) : -std::numbers::pi / 2;
  const Line phi = legendre_rule(y_points, first, std::numbers::pi / 2);
  const Line t = legendre_rule(v_points, -1, 1);

  const int count = y_points * v_points;
  Points points{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (int i = 0; i < y_points; ++i) {
    const double y = centre + reach * std::sin(phi.at[i]);
    const double width = half_width(y);
    const double y_weight = phi.weight[i] * reach * std::cos(phi.at[i]);
    points.y.segment(i * v_points, v_points).setConstant(y);
    points.v.segment(i * v_points, v_points) = width * t.at;
    points.weight.segment(i * v_points, v_points) = y_weight * width * t.weight;
  }
  return points;
}

Points EnergyDomain::wall_rule(int points) const {
  const double width = y_low_ == 0 ? half_width(0) : 0;
  if (width == 0) return {Eigen::VectorXd(0), Eigen::VectorXd(0), Eigen::VectorXd(0)};
  const Line v = legendre_rule(points, -width, 0);
  return {Eigen::VectorXd::Zero(points), v.at, v.weight};
}

}  // namespace fpkcheck::epc::moment
