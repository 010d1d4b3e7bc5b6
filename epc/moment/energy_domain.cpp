#include "epc/moment/energy_domain.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::moment {

using half_plane::QuadraturePoints;
using numerics::QuadratureRule;
using problem::HalfCycle;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kQuarterTurn = std::numbers::pi / 2;

}  // namespace

EnergyDomain::EnergyDomain(const problem::Problem& problem, double level)
    : potential_(problem),
      level_(level),
      wall_low_(problem.system.left_wall() ? problem.system.left_wall()->position : -kInfinity),
      wall_high_(problem.system.right_wall() ? problem.system.right_wall()->position : kInfinity) {
  assert(level > 0);
  const problem::UndampedOrbits orbits(problem);
  lowest_potential_ = orbits.lowest_potential();
  parts_ = orbits.half_cycles(lowest_potential_ + level_);
}

double EnergyDomain::turning_point(double from, double towards) const {
  const auto excess = [this](double y) { return energy(y, 0) - level_; };
  const auto [low, high] = std::minmax(from, towards);
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(), iterations);
  return (bracket.first + bracket.second) / 2;
}

double EnergyDomain::v_half_width(double y) const {
  return std::sqrt(std::max(0.0, 2 * (level_ - energy(y, 0))));
}

double EnergyDomain::v_max() const { return std::sqrt(2 * level_); }

// Returns the turning point that the motion would have behind a wall, at a distance of at most the
// width of the given part of the domain.
double EnergyDomain::turning_point_behind_wall(double wall, double far) const {
  constexpr int kSteps = 16;
  const double step = (wall - far) / kSteps;
  for (int k = 1; k <= kSteps; ++k) {
    const double at = wall + k * step;
    if (energy(at, 0) > level_) return turning_point(at - step, at);
  }
  return wall + (wall - far);
}

EnergyDomain::SineMap EnergyDomain::sine_map_of(const HalfCycle& part) const {
  // The half-width v_half_width() also has a singularity at the turning point that the motion would
  // have behind a wall. The substitution y = a + b sin(phi) removes this singularity, too.
  const double low = part.at_left ? turning_point_behind_wall(part.left, part.right) : part.left;
  const double high = part.at_right ? turning_point_behind_wall(part.right, part.left) : part.right;
  const double centre = (low + high) / 2, half_length = (high - low) / 2;
  return {centre, half_length,
          part.at_left ? std::asin((part.left - centre) / half_length) : -kQuarterTurn,
          part.at_right ? std::asin((part.right - centre) / half_length) : kQuarterTurn};
}

QuadraturePoints EnergyDomain::quadrature_points(int y_points, int v_points) const {
  const QuadratureRule tau = numerics::gauss_legendre_rule(v_points, -1, 1);
  QuadraturePoints points =
      QuadraturePoints::zeros(static_cast<Eigen::Index>(parts_.size()) * y_points * v_points);
  Eigen::Index k = 0;
  for (const HalfCycle& part : parts_) {
    const auto [centre, half_length, first, last] = sine_map_of(part);
    const QuadratureRule phi = numerics::gauss_legendre_rule(y_points, first, last);
    for (int i = 0; i < y_points; ++i) {
      const double y = centre + half_length * std::sin(phi.points[i]);
      const double width = v_half_width(y);
      const double y_weight = phi.weights[i] * half_length * std::cos(phi.points[i]);
      for (int j = 0; j < v_points; ++j, ++k) {
        points.y[k] = y;
        points.v[k] = width * tau.points[j];
        points.energy[k] = energy(y, points.v[k]);
        points.weight[k] = y_weight * width * tau.weights[j];
      }
    }
  }
  points.s = points.y;
  points.t = points.v;
  return points;
}

QuadratureRule EnergyDomain::left_wall_quadrature_rule(int point_count) const {
  const double width = parts_.front().at_left ? v_half_width(y_low()) : 0;
  if (width == 0) return {};
  return numerics::gauss_legendre_rule(point_count, -width, 0);
}

QuadratureRule EnergyDomain::right_wall_quadrature_rule(int point_count) const {
  const double width = parts_.back().at_right ? v_half_width(y_max()) : 0;
  if (width == 0) return {};
  return numerics::gauss_legendre_rule(point_count, 0, width);
}

}  // namespace fpkcheck::epc::moment
