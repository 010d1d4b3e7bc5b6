#include "epc/moment/energy_domain.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::moment {

using half_plane::Line;
using half_plane::Points;

namespace {

problem::Polynomial potential_of(const problem::Problem& problem) {
  auto a = problem.system.potential().coefficients();
  a[1] -= problem.impulses.rate_moment(1);
  return problem::Polynomial(a);
}

}  // namespace

EnergyDomain::EnergyDomain(const problem::Problem& problem, double level)
    : potential_(potential_of(problem)),
      level_(level),
      minimum_(problem::static_deflection(problem)),
      least_(potential_(minimum_)) {
  double beyond = minimum_ + 1;
  while (energy(beyond, 0) < level_) beyond = minimum_ + 2 * (beyond - minimum_);
  y_high_ = turning_point(minimum_, beyond);
  y_low_ = energy(0, 0) <= level_ ? 0 : turning_point(minimum_, 0);
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
  const Line phi = half_plane::legendre_rule(y_points, first, std::numbers::pi / 2);
  const Line tau = half_plane::legendre_rule(v_points, -1, 1);

  const Eigen::Index count = Eigen::Index{y_points} * v_points;
  Points points;
  for (auto* column : {&points.y, &points.v, &points.energy, &points.weight}) {
    column->resize(count);
  }
  Eigen::Index k = 0;
  for (int i = 0; i < y_points; ++i) {
    const double y = centre + reach * std::sin(phi.at[i]);
    const double width = half_width(y);
    const double y_weight = phi.weight[i] * reach * std::cos(phi.at[i]);
    for (int j = 0; j < v_points; ++j, ++k) {
      points.y[k] = y;
      points.v[k] = width * tau.at[j];
      points.energy[k] = energy(y, points.v[k]);
      points.weight[k] = y_weight * width * tau.weight[j];
    }
  }
  points.s = points.y;
  points.t = points.v;
  return points;
}

Line EnergyDomain::wall_rule(int points) const {
  const double width = y_low_ == 0 ? half_width(0) : 0;
  if (width == 0) return {};
  return half_plane::legendre_rule(points, -width, 0);
}

}  // namespace fpkcheck::epc::moment
