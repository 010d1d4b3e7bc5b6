#include "epc/moment/energy_domain.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::moment {

using half_plane::QuadraturePoints;
using numerics::QuadratureRule;
using problem::HalfCycle;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kQuarterTurn = std::numbers::pi / 2;

// Number of quadrature points of a panel that ends at a kink of a formula, in addition to points in
// proportion to its width
constexpr int kExtraPoints = 8;

// Returns the number of Gauss-Legendre points of each panel for a composite rule of about
// `point_count` points.
int points_per_panel(int point_count, std::size_t panels) {
  return panels == 1 ? point_count : point_count / static_cast<int>(panels) + kExtraPoints;
}

std::vector<double> panel_ends(double low, const std::vector<double>& kinks, double high) {
  std::vector<double> ends{low};
  std::ranges::copy_if(kinks, std::back_inserter(ends),
                       [&](double kink) { return low < kink && kink < high; });
  ends.push_back(high);
  return ends;
}

// Maps a quadrature rule on [-1, 1] by tau = t (a + (1 - a) t^2), a = kSpacing, which multiplies
// the distance between points near 0 by a.
void concentrate_points_at_zero(QuadratureRule& rule) {
  constexpr double kSpacing = 0.1;
  for (Eigen::Index i = 0; i < rule.size(); ++i) {
    double& t = rule.points[i];
    rule.weights[i] *= kSpacing + 3 * (1 - kSpacing) * t * t;
    t *= kSpacing + (1 - kSpacing) * t * t;
  }
}

// Returns the composite quadrature rule of Gauss-Legendre rules on all panels.
QuadratureRule join_panel_rules(const std::vector<double>& ends, int point_count) {
  const int points = points_per_panel(point_count, ends.size() - 1);
  QuadratureRule joined{{}, Eigen::VectorXd(static_cast<Eigen::Index>(ends.size() - 1) * points)};
  for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
    const QuadratureRule panel = numerics::gauss_legendre_rule(points, ends[n], ends[n + 1]);
    joined.weights.segment(std::ssize(joined.points), points) = panel.weights;
    joined.points.insert(joined.points.end(), panel.points.begin(), panel.points.end());
  }
  return joined;
}

std::vector<double> kinks_of_restitution(const problem::Wall& wall, double largest_speed) {
  return wall.has_constant_restitution() ? std::vector<double>{}
                                         : wall.restitution_formula->kinks_in_v(0, largest_speed);
}

}  // namespace

EnergySublevelSet::EnergySublevelSet(const problem::Problem& problem, double level)
    : potential_(problem),
      level_(level),
      left_wall_(problem.system.left_wall()),
      right_wall_(problem.system.right_wall()),
      wall_low_(left_wall_ ? left_wall_->position : -kInfinity),
      wall_high_(right_wall_ ? right_wall_->position : kInfinity) {
  assert(level > 0);
  const problem::UndampedOrbits orbits(problem);
  lowest_potential_ = orbits.lowest_potential();
  parts_ = orbits.half_cycles(lowest_potential_ + level_);
  y_kinks_ = problem::coefficient_kinks_in_y(problem, y_low(), y_max());
  v_kinks_ = problem::coefficient_kinks_in_v(problem, -v_max(), v_max());
  dense_at_rest_ = !problem.system.has_polynomial_force() && v_kinks_.empty();
}

double EnergySublevelSet::turning_point(double from, double towards) const {
  const auto excess = [this](double y) { return energy(y, 0) - level_; };
  const auto [low, high] = std::minmax(from, towards);
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(), iterations);
  return (bracket.first + bracket.second) / 2;
}

double EnergySublevelSet::velocity_half_width(double y) const {
  return std::sqrt(std::max(0.0, 2 * (level_ - energy(y, 0))));
}

double EnergySublevelSet::v_max() const { return std::sqrt(2 * level_); }

// Returns the turning point of the motion without the wall, behind the wall at a distance of at
// most the width of the given part of the domain.
double EnergySublevelSet::turning_point_behind_wall(double wall, double far) const {
  constexpr int kSteps = 16;
  const double step = (wall - far) / kSteps;
  for (int k = 1; k <= kSteps; ++k) {
    const double at = wall + k * step;
    if (energy(at, 0) > level_) return turning_point(at - step, at);
  }
  return wall + (wall - far);
}

EnergySublevelSet::SineMap EnergySublevelSet::sine_map_of_half_cycle(const HalfCycle& part) const {
  // The half-width velocity_half_width(y) also has a square-root singularity at the turning point
  // of the motion without the wall, behind the wall. The substitution y = a + b sin(phi) removes
  // the square-root singularities at the two ends of the domain.
  const double low =
      part.left_is_wall ? turning_point_behind_wall(part.left, part.right) : part.left;
  const double high =
      part.right_is_wall ? turning_point_behind_wall(part.right, part.left) : part.right;
  const double centre = (low + high) / 2, half_length = (high - low) / 2;
  return {centre, half_length,
          part.left_is_wall ? std::asin((part.left - centre) / half_length) : -kQuarterTurn,
          part.right_is_wall ? std::asin((part.right - centre) / half_length) : kQuarterTurn};
}

QuadraturePoints EnergySublevelSet::quadrature_points(int y_points, int v_points) const {
  QuadratureRule tau =
      numerics::gauss_legendre_rule(points_per_panel(v_points, v_kinks_.size() + 1), -1, 1);
  if (dense_at_rest_) concentrate_points_at_zero(tau);
  std::vector<double> y, v, energies, weights;
  for (const HalfCycle& part : parts_) {
    const auto [centre, half_length, first, last] = sine_map_of_half_cycle(part);
    std::vector<double> phi_ends = panel_ends(part.left, y_kinks_, part.right);
    for (double& end : phi_ends)
      end = std::asin(std::clamp((end - centre) / half_length, -1.0, 1.0));
    phi_ends.front() = first;
    phi_ends.back() = last;
    const QuadratureRule phi = join_panel_rules(phi_ends, y_points);
    for (Eigen::Index i = 0; i < phi.size(); ++i) {
      const double at = centre + half_length * std::sin(phi.points[i]);
      const double potential = energy(at, 0);
      const double width = velocity_half_width(at);
      const double y_weight = phi.weights[i] * half_length * std::cos(phi.points[i]);
      const std::vector<double> v_ends = panel_ends(-width, v_kinks_, width);
      for (std::size_t n = 0; n + 1 < v_ends.size(); ++n) {
        const double middle = (v_ends[n] + v_ends[n + 1]) / 2;
        const double half_panel = (v_ends[n + 1] - v_ends[n]) / 2;
        for (Eigen::Index j = 0; j < tau.size(); ++j) {
          y.push_back(at);
          v.push_back(middle + half_panel * tau.points[j]);
          energies.push_back(v.back() * v.back() / 2 + potential);
          weights.push_back(y_weight * half_panel * tau.weights[j]);
        }
      }
    }
  }
  const auto vector = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
  };
  return {.s = vector(y),
          .t = vector(v),
          .y = vector(y),
          .v = vector(v),
          .energy = vector(energies),
          .weight = vector(weights)};
}

QuadratureRule EnergySublevelSet::left_wall_quadrature_rule(int point_count) const {
  const double width = parts_.front().left_is_wall ? velocity_half_width(y_low()) : 0;
  if (width == 0) return {};
  std::vector<double> ends = panel_ends(0, kinks_of_restitution(*left_wall_, width), width);
  std::ranges::reverse(ends);
  for (double& end : ends) end = end == 0 ? 0 : -end;
  return join_panel_rules(ends, point_count);
}

QuadratureRule EnergySublevelSet::right_wall_quadrature_rule(int point_count) const {
  const double width = parts_.back().right_is_wall ? velocity_half_width(y_max()) : 0;
  if (width == 0) return {};
  return join_panel_rules(panel_ends(0, kinks_of_restitution(*right_wall_, width), width),
                          point_count);
}

}  // namespace fpkcheck::epc::moment
