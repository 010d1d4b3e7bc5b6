#include "mcs/motion/oscillator.hpp"

#include <algorithm>
#include <cmath>

#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

// Impact speed, as a fraction of the velocity scale, below which the series of bounces is summed
// with a constant force at the wall. The neglected change of the force changes E[y'^2] and the
// duration of the bounces by the relative amount 1e-6, the square of kRestSpeedFraction.
constexpr double kRestSpeedFraction = 1e-3;

double largest_damping(const problem::System& system, const problem::MotionScales& scales) {
  const double v2 = scales.velocity_deviation * scales.velocity_deviation;
  double largest = 0;
  for (const double y : {scales.centre, scales.centre - scales.displacement_deviation,
                         scales.centre + scales.displacement_deviation}) {
    if (system.has_polynomial_force()) {
      largest = std::max(largest, std::abs(system.damping_polynomial()(y)));
      continue;
    }
    for (const double share : {-1.0, -0.3, 0.3, 1.0}) {
      const double v = share * scales.velocity_deviation;
      largest = std::max(largest, std::abs(system.damping_force(y, v) / v));
    }
  }
  if (!system.has_polynomial_force()) return largest;
  return largest + std::abs(system.rayleigh_coefficient()) * v2;
}

void set_polynomials(const problem::System& system, bool damping_in_kicks, Oscillator& o) {
  for (std::size_t n = 0; n < o.force.size(); ++n)
    o.force[n] = system.restoring_force().coefficient(n);
  // Constant damping c y' is part of the noise kicks.
  if (!damping_in_kicks) {
    for (std::size_t n = 0; n < o.damping.size(); ++n) {
      o.damping[n] = system.damping_polynomial().coefficient(n);
    }
  }
  o.rayleigh = system.rayleigh_coefficient();
}

Oscillator::Kind kind_of(const problem::Problem& problem, const Oscillator& o) {
  using Kind = Oscillator::Kind;
  if (!problem.system.has_polynomial_force()) return Kind::formula;
  const auto degree = problem.system.restoring_force().degree();
  const bool even_damping = o.damping[1] == 0 && o.damping[2] == 0;
  return is_duffing_at_wall(problem)                      ? Kind::duffing_at_wall
         : degree <= 1 && even_damping && o.rayleigh == 0 ? Kind::linear
         : degree <= 3 && o.rayleigh == 0                 ? Kind::cubic
                                                          : Kind::full;
}

}  // namespace

bool is_duffing_at_wall(const problem::Problem& problem) {
  const problem::System& system = problem.system;
  if (!system.has_polynomial_force() || !system.has_constant_restitution()) return false;
  const numerics::Polynomial& g = system.restoring_force();
  const double k = g.coefficient(1), mu = g.coefficient(3);
  const bool is_duffing = g.coefficient(0) == 0 && g.coefficient(2) == 0 && g.degree() <= 3 &&
                          k >= 0 && mu >= 0 && k + mu > 0;
  return is_duffing && system.has_constant_damping() && system.damping() > 0 &&
         system.left_wall() && system.left_wall()->position == 0 && !system.right_wall() &&
         !problem.noise.is_present();
}

Oscillator make_oscillator(const problem::Problem& problem, const problem::MotionScales& scales,
                           double mean_force, bool has_noise_kicks) {
  const problem::System& system = problem.system;
  Oscillator o;
  if (system.has_polynomial_force()) {
    set_polynomials(system, has_noise_kicks && system.has_constant_damping(), o);
  } else {
    o.system = &system;
    o.has_jumps = system.has_force_jumps();
    o.has_kinks = system.formula().has_kinks();
  }
  o.force[0] -= mean_force;
  o.kind = kind_of(problem, o);
  o.length = scales.displacement_deviation;
  o.frequency = scales.frequency;
  const double rate = scales.frequency + largest_damping(system, scales);
  const auto make_wall = [&](const problem::Wall& wall, double inwards) {
    Wall w{.exists = true, .position = wall.position, .restitution = wall.restitution};
    w.contact_force = inwards * (system.force(wall.position, 0) - mean_force);
    if (w.contact_force > 0) {
      w.rest_speed =
          kRestSpeedFraction * std::min(scales.velocity_deviation, w.contact_force / rate);
    }
    return w;
  };
  if (system.left_wall()) o.left = make_wall(*system.left_wall(), 1);
  if (system.right_wall()) o.right = make_wall(*system.right_wall(), -1);
  return o;
}

NoiseKicks make_noise_kicks(const problem::Problem& problem, const problem::MotionScales& scales,
                            double diffusion, double step) {
  if (diffusion == 0) return {};
  const problem::System& system = problem.system;
  NoiseKicks kicks{.diffusion = diffusion};
  if (system.has_constant_damping()) kicks.damping = system.damping();
  kicks.longest_interval = step / (scales.frequency + 2 * largest_damping(system, scales));
  constexpr double kGrading = 1e-5;
  kicks.shortest_interval = kGrading * kicks.longest_interval;
  const auto has_losses = [](const std::optional<problem::Wall>& w) {
    return w && w->restitution < 1;
  };
  kicks.has_lossy_wall = has_losses(system.left_wall()) || has_losses(system.right_wall());
  return kicks;
}

void evaluate_forces(const Oscillator& oscillator, int count, const double* y, const double* v,
                     double* force) {
  const problem::System& system = *oscillator.system;
  system.evaluate_forces(static_cast<std::size_t>(count), y, v, force);
  for (int k = 0; k < count; ++k) {
    if (std::isfinite(force[k])) continue;
    double inside = y[k];
    if (oscillator.left.exists) inside = std::max(inside, oscillator.left.position);
    if (oscillator.right.exists) inside = std::min(inside, oscillator.right.position);
    if (inside != y[k]) force[k] = system.force(inside, v[k]);
  }
}

}  // namespace fpkcheck::mcs
