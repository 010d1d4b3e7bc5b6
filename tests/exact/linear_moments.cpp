#include "exact/linear_moments.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "base/input_error.hpp"

namespace fpkcheck::exact {
namespace {

void require(bool holds, const char* key, double value, const char* requirement) {
  if (holds) return;
  throw InputError(fmt::format("{} = {}: the exact moments of the linear oscillator require {}",
                               key, value, requirement));
}

void require_linear(const problem::System& system) {
  require(system.has_linear_force(), "system.cubic", system.restoring_force().coefficient(3), "0");
  require(system.has_constant_damping(), "system.damping", system.damping(), "f = c y'");
}

}  // namespace

LinearMoments linear_moments_at(const problem::Problem& problem, const MeanAndCovariance& start,
                                double time) {
  const auto& system = problem.system;
  const auto& impulses = problem.impulses;
  require_linear(system);
  require(!system.left_wall() || system.left_wall()->position == 0, "wall.left",
          system.left_wall() ? system.left_wall()->position : 0, "a wall at 0");
  require(!system.right_wall(), "wall.right",
          system.right_wall() ? system.right_wall()->position : 0, "none");
  require(system.restitution() == 1, "system.restitution", system.restitution(), "1");
  require(impulses.amplitude_law().mean() == 0, "impulse.mean", impulses.amplitude_law().mean(),
          "0");
  require(impulses.amplitude_law().is_symmetric(), "impulse.skewness",
          impulses.amplitude_law().skewness(), "0");
  require(std::isfinite(time) && time >= 0, "time", time, "a finite time, not negative");

  const double c = system.damping(), k = system.stiffness();
  const double velocity_variance = problem::total_excitation_intensity(problem) / (2 * c);
  Eigen::Matrix2d generator;
  generator << 0, 1, -k, -c;
  const Eigen::Matrix2d propagator = (generator * time).exp();
  const Eigen::Vector2d mean(start.z, start.v);
  Eigen::Matrix2d covariance;
  covariance << start.var_z, start.cov_zv, start.cov_zv, start.var_v;
  const Eigen::Matrix2d stationary =
      Eigen::Vector2d(velocity_variance / k, velocity_variance).asDiagonal();

  const Eigen::Vector2d first = propagator * mean;
  const Eigen::Matrix2d second =
      stationary +
      propagator * (covariance + mean * mean.transpose() - stationary) * propagator.transpose();
  return {first(0), first(1), second(0, 0), second(0, 1), second(1, 1)};
}

LinearMoments linear_moments_in_time(const problem::Problem& problem,
                                     const MeanAndCovariance& start, double time) {
  const auto& system = problem.system;
  require_linear(system);
  const double c = system.damping(), k = system.stiffness();
  using State = std::array<double, 5>;
  State m{start.z, start.v, start.var_z + start.z * start.z, start.cov_zv + start.z * start.v,
          start.var_v + start.v * start.v};
  const auto rates = [&](const State& x, State& rate, double t) {
    const auto& [z, v, zz, zv, vv] = x;
    const double a = problem.time.rate_factor(t);
    const double force = problem.impulses.rate_times_moment(1) * a + problem.time.external_force(t);
    const double intensity = problem.impulses.rate_times_moment(2) * a +
                             problem.noise.intensity * problem.time.intensity_factor(t);
    rate = {v, -k * z - c * v + force, 2 * zv, vv - k * zz - c * zv + force * z,
            -2 * k * zv - 2 * c * vv + 2 * force * v + intensity};
  };
  namespace odeint = boost::numeric::odeint;
  constexpr double kTolerance = 1e-10, kFirstStep = 1e-3;
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(kTolerance, kTolerance), rates, m,
      0.0, time, kFirstStep);
  return {m[0], m[1], m[2], m[3], m[4]};
}

}  // namespace fpkcheck::exact
