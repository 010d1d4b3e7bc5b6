#include "problem/undamped_orbits.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "numerics/roots/bracketed_root.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::problem {
namespace {

constexpr int kRootBits = 50;  // number of correct bits of a turning point

// Returns the mean of the damping coefficients at the velocities v and -v, that is, the part of the
// damping force that is odd in v, divided by v.
double mean_damping(const System& system, double y, double v) {
  if (system.has_polynomial_force()) {
    return system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v;
  }
  return v > 0 ? (system.force(y, v) - system.force(y, -v)) / (2 * v) : 0;
}

}  // namespace

UndampedOrbits::UndampedOrbits(const Problem& problem) : problem_(problem), potential_(problem) {
  // The potential V is monotone between neighbouring knots. The slope of the potential V between a
  // knot and the next knot decides whether the knot is a minimum.
  std::vector<double> knots{potential_.y_low()};
  knots.insert(knots.end(), potential_.extremum_positions().begin(),
               potential_.extremum_positions().end());
  knots.push_back(potential_.y_high());
  for (std::size_t n = 0; n + 1 < knots.size(); ++n) {
    const double after = potential_.potential_slope((knots[n] + knots[n + 1]) / 2);
    const bool is_turn = n > 0;
    if (is_turn ? after > 0 : problem_.system.left_wall() && after >= 0)
      minima_.push_back(knots[n]);
    const bool last = n + 2 == knots.size();
    if (last && problem_.system.right_wall() && after < 0) minima_.push_back(potential_.y_high());
  }
}

bool UndampedOrbits::is_confining_on_right() const {
  return problem_.system.right_wall() || potential_.is_unbounded_on_right();
}

bool UndampedOrbits::is_confining_on_left() const {
  return problem_.system.left_wall() || potential_.is_unbounded_on_left();
}

double UndampedOrbits::deepest_minimum() const {
  assert(is_confining());
  return *std::ranges::min_element(minima_, {}, [&](double y) { return potential_(y); });
}

// Returns the turning point, where the potential V equals the energy, beyond a knot with V <
// energy. The parameter `direction` (+1 or -1) is the direction from the knot in which V increases
// without bound.
double UndampedOrbits::find_turning_point(double knot, double direction, double energy) const {
  const auto above = [&](double distance) {
    return potential_(knot + direction * distance) - energy;
  };
  // The distance of the turning point from the knot lies between two powers of two. The exponents
  // of the two powers of two are found by doubled steps from the distance 1, then by bisection.
  const int least = std::ilogb(std::max(std::abs(knot) * 1e-8, 1e-30));
  const auto is_above = [&](int exponent) { return !(above(std::ldexp(1.0, exponent)) < 0); };
  int inside = 0, outside = 0;
  if (is_above(0)) {
    for (int step = 1; inside > least && is_above(inside); step *= 2) {
      outside = inside;
      inside = std::max(inside - step, least);
    }
  } else {
    for (int step = 1; !is_above(outside); step *= 2) {
      inside = outside;
      outside += step;
    }
  }
  while (outside - inside > 1) {
    const int middle = std::midpoint(inside, outside);
    (is_above(middle) ? outside : inside) = middle;
  }
  const double nearest = inside > least ? std::ldexp(1.0, inside) : 0;
  return knot +
         direction * numerics::bracketed_root(above, nearest, std::ldexp(1.0, outside), kRootBits);
}

std::vector<HalfCycle> UndampedOrbits::half_cycles(double energy) const {
  assert(is_confining());
  std::vector<double> knots = potential_.extremum_positions();
  if (problem_.system.left_wall())
    knots.insert(knots.begin(), problem_.system.left_wall()->position);
  if (problem_.system.right_wall()) knots.push_back(problem_.system.right_wall()->position);
  if (knots.empty()) return {};
  const auto above = [&](double y) { return potential_(y) - energy; };
  const auto below = [&](double y) { return above(y) < 0; };
  std::vector<HalfCycle> all;
  HalfCycle open{};
  bool inside = below(knots.front());
  if (inside) {
    open.left_is_wall = problem_.system.left_wall().has_value();
    open.left = open.left_is_wall ? knots.front() : find_turning_point(knots.front(), -1, energy);
  }
  for (std::size_t n = 0; n + 1 < knots.size(); ++n) {
    const bool next = below(knots[n + 1]);
    if (inside == next) continue;
    const double at = numerics::bracketed_root(above, knots[n], knots[n + 1], kRootBits);
    if (inside) {
      open.right = at;
      open.right_is_wall = false;
      all.push_back(open);
    } else {
      open = {.left = at, .right = at, .left_is_wall = false, .right_is_wall = false};
    }
    inside = next;
  }
  if (inside) {
    open.right_is_wall = problem_.system.right_wall().has_value();
    open.right = open.right_is_wall ? knots.back() : find_turning_point(knots.back(), 1, energy);
    all.push_back(open);
  }
  return all;
}

OrbitIntegrals UndampedOrbits::orbit_integrals(const HalfCycle& half_cycle, double energy) const {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  OrbitIntegrals orbit{.half_cycle = half_cycle};
  const double middle = (half_cycle.left + half_cycle.right) / 2,
               half = (half_cycle.right - half_cycle.left) / 2;
  const auto speed = [&](double y) {
    return std::sqrt(std::max(0.0, 2 * (energy - potential_(y))));
  };
  const double impulse_diffusion = problem_.impulses.rate_times_moment(2) / 2;
  // Closed integrals of D G v dy and of lambda E[Y^2] b^2/2 v dy, used if the factor of noise (G =
  // g^2) or of impulses b is a formula
  double of_noise = 0, of_impulses = 0;
  // With the substitution y = middle + half sin(phase), the velocity v and the derivative dy/dphase
  // both behave like cos(phase) at a turning point, so that dy / v is smooth in the phase.
  const auto add = [&](double phase, double weight) {
    const double y = middle + half * std::sin(phase);
    // The factor 2 counts the two half-cycles of a period.
    const double dy = 2 * weight * half * std::cos(phase);
    const double v = speed(y);
    const double damping = mean_damping(problem_.system, y, v);
    orbit.action += v * dy;
    orbit.loss += damping * v * dy;
    if (const auto& g = problem_.noise_factor) {
      const double slope =
          (g->squared_noise_factor_slope_in_v(y, v) - g->squared_noise_factor_slope_in_v(y, -v)) /
          2;
      orbit.loss += problem_.noise.diffusion() * slope * dy;
      of_noise += (noise_diffusion_coefficient(problem_, y, v) +
                   noise_diffusion_coefficient(problem_, y, -v)) /
                  2 * v * dy;
    }
    if (problem_.impulse_factor) {
      of_impulses += impulse_diffusion * squared_impulse_factor(problem_, y) * v * dy;
    }
    if (v <= 0) return;
    orbit.period += dy / v;
    orbit.time_integral_y += y * dy / v;
    orbit.time_integral_y2 += y * y * dy / v;
    orbit.time_integral_damping += damping * dy / v;
  };
  constexpr double kQuarter = std::numbers::pi / 2;
  for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n) {
    const double x = Gauss::abscissa()[n], weight = Gauss::weights()[n] * kQuarter;
    add(kQuarter * x, weight);
    add(-kQuarter * x, weight);
  }
  orbit.diffusion = (problem_.noise_factor ? of_noise : problem_.noise.diffusion() * orbit.action) +
                    (problem_.impulse_factor ? of_impulses : impulse_diffusion * orbit.action);
  const auto bounce = [&](const Wall& wall) {
    orbit.loss += energy_loss_at_impact(wall, ImpactCondition::map, speed(wall.position));
  };
  if (half_cycle.left_is_wall) bounce(*problem_.system.left_wall());
  if (half_cycle.right_is_wall) bounce(*problem_.system.right_wall());
  return orbit;
}

}  // namespace fpkcheck::problem
