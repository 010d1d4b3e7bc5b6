#include "exact/inelastic_ball.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "base/input_error.hpp"
#include "exact/wall_exponent.hpp"

namespace fpkcheck::exact {
namespace {

constexpr double kNegligible = 1e-9;
// Step of log u and log t. A smaller step changes the results by less than 1e-8 up to r = 0.8.
constexpr double kStep = 0.12;

}  // namespace

double InelasticBall::kernel(double a, double b) {
  constexpr double kExponent = 45;  // e^-45 = 3e-20 is negligible
  const double square = 2 * (a * a - a * b + b * b), linear = a + b;
  // The range of t with square / t + t / 2 - linear below kExponent, enlarged by a factor of 2.
  const double half = kExponent + linear, root = std::sqrt(half * half - 2 * square);
  const double from = std::log(square / (half + root)) - std::numbers::ln2;
  const double to = std::log(half + root) + std::numbers::ln2;
  double sum = 0;
  for (double x = from; x < to; x += kStep) {
    const double t = std::exp(x);
    sum += std::exp(linear - square / t - t / 2) * std::erf(std::sqrt(6 * a * b / t)) / t;
  }
  return std::numbers::sqrt3 * a / std::numbers::pi * kStep * sum;
}

InelasticBall::InelasticBall(double restitution) : restitution_(restitution) {
  const double beta = wall_exponent(restitution);
  if (restitution == 1) throw InputError("restitution = 1: an elastic floor has no stationary law");
  const double from = std::log(kNegligible) / (2 - beta);
  const double to = std::log(-std::log(kNegligible) * 2 / (1 - restitution));
  for (double x = from; x < to; x += kStep) speeds_.push_back(std::exp(x));
  // The stationary masses m of the Markov chain of impacts: M m = m and 1^T m = 1, solved as
  // (1 - M + w 1^T) m = w.
  const auto n = std::ssize(speeds_);
  Eigen::MatrixXd returns(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double rebound_speed = restitution * speeds_[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < n; ++i) {
      const double speed = speeds_[static_cast<std::size_t>(i)];
      returns(i, j) = speed * kernel(speed, rebound_speed);
    }
    returns.col(j) /= returns.col(j).sum();
  }
  const Eigen::VectorXd uniform = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  const Eigen::MatrixXd chain =
      Eigen::MatrixXd::Identity(n, n) - returns + uniform * Eigen::RowVectorXd::Ones(n);
  const Eigen::VectorXd masses = chain.partialPivLu().solve(uniform);
  masses_.assign(masses.begin(), masses.end());
}

double InelasticBall::speed_moment(int n) const {
  double sum = 0;
  for (std::size_t i = 0; i < speeds_.size(); ++i) sum += masses_[i] * std::pow(speeds_[i], n);
  return sum;
}

double InelasticBall::impact_rate() const { return 1 / ((1 + restitution_) * speed_moment(1)); }

// The balance of v^3 is -3 E[v^2] + 3 E[v] + rate (1 + r^3) E[u^3] = 0, that of y v is
// E[v^2] - E[y] = 0.
double InelasticBall::mean_height() const {
  return impact_rate() * (1 + std::pow(restitution_, 3)) * speed_moment(3) / 3;
}

// The balance of v^4 is -4 E[v^3] + 6 E[v^2] - rate (1 - r^4) E[u^4] = 0; E[v^4] follows from that
// of v^5.
double InelasticBall::fourth_velocity_moment() const {
  const double r = restitution_;
  const double v3 =
      (6 * mean_height() - impact_rate() * (1 - std::pow(r, 4)) * speed_moment(4)) / 4;
  return (10 * v3 + impact_rate() * (1 + std::pow(r, 5)) * speed_moment(5)) / 5;
}

}  // namespace fpkcheck::exact
