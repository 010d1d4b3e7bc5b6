#include "mcs/motion/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

// Impact speed, as a fraction of the velocity scale, below which the series of bounces is summed
// with a constant force at the wall. Since the force varies during a bounce, the summed series of
// bounces has relative errors of 1e-6, the square of kRestSpeedFraction, in E[y'^2] and in its
// duration.
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

// Returns the largest squared velocity slope of the noise factor g, (dg/dv)^2 = G_v^2 / (4 G) with
// G = g^2.
double largest_square_slope(const problem::NoiseFactor& factor,
                            const problem::MotionScales& scales) {
  double largest = 0;
  for (const double y : {-1.0, 0.0, 1.0}) {
    for (const double v : {-1.0, -0.3, 0.3, 1.0}) {
      const double at_y = scales.centre + y * scales.displacement_deviation,
                   at_v = v * scales.velocity_deviation;
      const double slope = factor.squared_noise_factor_slope_in_v(at_y, at_v);
      largest = std::max(largest, slope * slope / (4 * factor.squared_noise_factor(at_y, at_v)));
    }
  }
  return largest;
}

void set_formula_terms(const problem::Problem& problem, SimulatedOscillator& o) {
  const problem::System& system = problem.system;
  o.system = &system;
  if (!system.has_polynomial_force()) {
    o.has_jumps = system.has_force_jumps();
    o.has_kinks = system.force_formula().has_kinks();
  }
  if (!problem.noise_factor || !problem.noise_factor->depends_on_v()) return;
  o.noise_factor = &*problem.noise_factor;
  o.diffusion = problem.noise.diffusion();
  o.is_force_in_ito_sense = problem.noise.interpretation == problem::NoiseInterpretation::ito;
  // For an equation in Ito's sense the force of the free flights contains the slope of the noise
  // factor g, which jumps at a kink of g.
  if (o.is_force_in_ito_sense && problem.noise_factor->has_kinks())
    o.has_jumps = o.has_kinks = true;
}

double clamp_to_walls(const SimulatedOscillator& o, double y) {
  if (o.left.exists) y = std::max(y, o.left.position);
  if (o.right.exists) y = std::min(y, o.right.position);
  return y;
}

void set_polynomial_coefficients(const problem::System& system, bool damping_in_kicks,
                                 SimulatedOscillator& o) {
  for (std::size_t n = 0; n < o.force.size(); ++n)
    o.force[n] = system.restoring_force().coefficient(n);
  // If noise kicks contain the damping force c y', the free flights have no damping force c y'.
  if (!damping_in_kicks) {
    for (std::size_t n = 0; n < o.damping.size(); ++n) {
      o.damping[n] = system.damping_polynomial().coefficient(n);
    }
  }
  o.rayleigh = system.rayleigh_coefficient();
}

// Returns whether the free flights are FormulaFlights, in which all of the damping acts.
bool has_formula_flights(const problem::Problem& problem) {
  return !problem.system.has_polynomial_force() || problem.noise_factor ||
         problem.time.has_external_force();
}

SimulatedOscillator::Kind oscillator_kind(const problem::Problem& problem,
                                          const SimulatedOscillator& o) {
  using Kind = SimulatedOscillator::Kind;
  if (o.system != nullptr) return Kind::formula;
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
  if (!system.has_polynomial_force() || !system.has_constant_restitution() ||
      problem.impulse_factor) {
    return false;
  }
  const numerics::Polynomial& g = system.restoring_force();
  const double k = g.coefficient(1), mu = g.coefficient(3);
  const bool is_duffing = g.coefficient(0) == 0 && g.coefficient(2) == 0 && g.degree() <= 3 &&
                          k >= 0 && mu >= 0 && k + mu > 0;
  return is_duffing && system.has_constant_damping() && system.damping() > 0 &&
         system.left_wall() && system.left_wall()->position == 0 && !system.right_wall() &&
         !problem.noise.is_acting() && !problem.time.has_external_force();
}

SimulatedOscillator make_oscillator(const problem::Problem& problem,
                                    const problem::MotionScales& scales, double mean_force,
                                    bool has_noise_kicks) {
  const problem::System& system = problem.system;
  SimulatedOscillator o;
  if (problem.time.has_external_force()) o.external_force = &problem.time;
  if (has_formula_flights(problem)) {
    set_formula_terms(problem, o);
  } else {
    set_polynomial_coefficients(system, has_noise_kicks && system.has_constant_damping(), o);
  }
  if (problem.impulse_factor) o.impulse_factor = &*problem.impulse_factor;
  o.force[0] -= mean_force;
  o.kind = oscillator_kind(problem, o);
  o.length = scales.displacement_deviation;
  o.velocity = scales.velocity_deviation;
  o.frequency = scales.frequency;
  o.fastest_rate = scales.frequency + largest_damping(system, scales);
  const auto make_wall = [&](const problem::Wall& wall, double inwards) {
    SimulatedWall w{.exists = true, .position = wall.position, .restitution = wall.restitution};
    if (!wall.has_constant_restitution()) w.formula = &wall;
    double force = system.force(wall.position, 0);
    if (o.noise_factor != nullptr) {
      constexpr double kAtRest = 0;
      evaluate_forces(o, 1, &wall.position, &kAtRest, &force);
    }
    set_contact_force(o, inwards * (force - mean_force), w);
    return w;
  };
  if (system.left_wall()) o.left = make_wall(*system.left_wall(), 1);
  if (system.right_wall()) o.right = make_wall(*system.right_wall(), -1);
  return o;
}

void set_contact_force(const SimulatedOscillator& oscillator, double force, SimulatedWall& wall) {
  wall.contact_force = force;
  wall.rest_speed =
      kRestSpeedFraction *
      std::max(0.0, std::min(oscillator.velocity, wall.contact_force / oscillator.fastest_rate));
}

void evaluate_external_forces(const SimulatedOscillator& oscillator, int count, const double* t,
                              double* force) {
  for (int k = 0; k < count; ++k) force[k] = oscillator.external_force->external_force(t[k]);
}

NoiseKicks make_noise_kicks(const problem::Problem& problem, const problem::MotionScales& scales,
                            double diffusion, double step) {
  if (diffusion == 0) return {};
  const problem::System& system = problem.system;
  NoiseKicks kicks{.diffusion = diffusion};
  if (system.has_constant_damping() && !has_formula_flights(problem)) {
    kicks.damping = system.damping();
  }
  double rate = scales.frequency + 2 * largest_damping(system, scales);
  if (problem.noise_factor) {
    kicks.factor = &*problem.noise_factor;
    kicks.velocity_scale = scales.velocity_deviation;
    rate += 2 * diffusion * largest_square_slope(*problem.noise_factor, scales);
  }
  kicks.longest_interval = step / rate;
  constexpr double kGrading = 1e-5;
  kicks.shortest_interval = kGrading * kicks.longest_interval;
  const auto has_losses = [](const std::optional<problem::Wall>& w) {
    return w && (w->restitution < 1 || !w->has_constant_restitution());
  };
  kicks.has_lossy_wall = has_losses(system.left_wall()) || has_losses(system.right_wall());
  return kicks;
}

double restitution_at_speed(const SimulatedWall& wall, double speed) {
  return wall.formula->restitution_at_speed(speed);
}

double total_bounce_time(const SimulatedWall& wall, double speed) {
  // The geometric series of a constant restitution coefficient r replaces the remaining bounces as
  // soon as r(u) is close to r(0), or the remaining bounces are short. If the restitution
  // coefficient is r(u) = 1 - O(u^a) with an exponent a < 1, some hundred bounces suffice; for an
  // exponent a >= 1 the bounces never end.
  constexpr int kMostBounces = 1000;
  constexpr double kTolerance = 1e-3;
  double sum = 0, u = speed;
  for (int n = 0;; ++n) {
    const double r = restitution_at_speed(wall, u);
    const bool is_constant = std::abs(wall.restitution - r) <= kTolerance * (1 - r);
    const double others = u * (2 * r / ((1 - r) * wall.contact_force));
    if (is_constant || others < kTolerance * sum) return sum + others;
    if (n == kMostBounces) return std::numeric_limits<double>::infinity();
    u *= r;
    sum += 2 * u / wall.contact_force;
  }
}

namespace {

// Computes the force by the formula in the case file, without a correction for Ito's sense. At
// points behind a wall, a force that is not finite is replaced by the force at the wall.
void evaluate_forces_as_written(const SimulatedOscillator& oscillator, int count, const double* y,
                                const double* v, double* force) {
  const problem::System& system = *oscillator.system;
  system.evaluate_forces(static_cast<std::size_t>(count), y, v, force);
  if (!oscillator.left.exists && !oscillator.right.exists) return;
  int finite = 0;
  for (int k = 0; k < count; ++k) finite += static_cast<int>(std::isfinite(force[k]));
  if (finite == count) return;
  for (int k = 0; k < count; ++k) {
    if (std::isfinite(force[k])) continue;
    const double inside = clamp_to_walls(oscillator, y[k]);
    if (inside != y[k]) system.evaluate_forces(1, &inside, &v[k], &force[k]);
  }
}

// Adds a multiple of the slope G_v of the squared noise factor G = g^2 to the forces; the drifts in
// Ito's sense and in Stratonovich's sense differ by D G_v / 2.
void add_noise_induced_drift(const SimulatedOscillator& oscillator, int count, const double* y,
                             const double* v, double multiple, double* force) {
  std::array<double, problem::Expression::kBatchPoints> inside{}, slopes{};
  for (int k = 0; k < count; ++k) inside[k] = clamp_to_walls(oscillator, y[k]);
  oscillator.noise_factor->evaluate_squared_noise_slopes_in_v(static_cast<std::size_t>(count),
                                                              inside.data(), v, slopes.data());
  for (int k = 0; k < count; ++k) force[k] += multiple * slopes[k];
}

}  // namespace

double impulse_factor(const SimulatedOscillator& oscillator, double y) {
  if (oscillator.impulse_factor == nullptr) return 1;
  return (*oscillator.impulse_factor)(clamp_to_walls(oscillator, y), 0);
}

void evaluate_forces(const SimulatedOscillator& oscillator, int count, const double* y,
                     const double* v, double* force) {
  evaluate_forces_as_written(oscillator, count, y, v, force);
  if (oscillator.noise_factor != nullptr && oscillator.is_force_in_ito_sense)
    add_noise_induced_drift(oscillator, count, y, v, oscillator.diffusion / 2, force);
}

void evaluate_ito_forces(const SimulatedOscillator& oscillator, int count, const double* y,
                         const double* v, double* force) {
  evaluate_forces_as_written(oscillator, count, y, v, force);
  if (oscillator.noise_factor != nullptr && !oscillator.is_force_in_ito_sense)
    add_noise_induced_drift(oscillator, count, y, v, -oscillator.diffusion / 2, force);
}

}  // namespace fpkcheck::mcs
