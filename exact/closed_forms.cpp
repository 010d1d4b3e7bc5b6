#include "exact/closed_forms.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "parameters/input_error.hpp"

namespace fpkcheck::exact {
namespace {

void require_elastic(const problem::Problem& problem) {
  if (problem.system.restitution() != 1) {
    throw InputError("no exact density is known with losses at the impact (restitution < 1)");
  }
}

}  // namespace

WhiteNoiseDensity::WhiteNoiseDensity(const problem::Problem& problem)
    : beta_(2 * problem.system.damping() / problem.impulses.intensity()),
      mean_force_(problem.impulses.rate_moment(1)),
      potential_(problem.system.potential()) {
  require_elastic(problem);
  boost::math::quadrature::exp_sinh<double> integrate;
  displacement_norm_ = 1;
  displacement_norm_ = integrate.integrate([this](double y) { return displacement_marginal(y); });
}

double WhiteNoiseDensity::operator()(double x1, double x2) const {
  // The two halves of the (z, z') plane carry the same mass.
  return displacement_marginal(std::abs(x1)) * velocity_marginal(x2) / 2;
}

double WhiteNoiseDensity::displacement_marginal(double y) const {
  return std::exp(-beta_ * (potential_(y) - mean_force_ * y)) / displacement_norm_;
}

double WhiteNoiseDensity::velocity_marginal(double v) const {
  return boost::math::pdf(boost::math::normal(0, 1 / std::sqrt(beta_)), v);
}

double mean_square_velocity(const problem::Problem& problem) {
  require_elastic(problem);
  return problem.impulses.intensity() / (2 * problem.system.damping());
}

double linear_cumulant(const problem::Problem& problem, int p, int q) {
  require_elastic(problem);
  const double c = problem.system.damping();
  const double w2 = problem.system.stiffness() - c * c / 4;
  const bool folded = problem.system.left() || problem.system.right();
  const auto& impulses = problem.impulses;
  const bool symmetric = impulses.rate_moment(1) == 0 && impulses.law().symmetric();
  if (!problem.system.linear() || w2 <= 0 || (folded && !symmetric)) {
    throw InputError(
        "the exact cumulants hold for a linear, underdamped oscillator, with a wall under a symmetric "
        "law only");
  }
  const double w = std::sqrt(w2);
  const auto response = [&](double t) {
    const double decay = std::exp(-c * t / 2);
    const double h = decay * std::sin(w * t) / w;
    const double h_dot = decay * (std::cos(w * t) - c / (2 * w) * std::sin(w * t));
    return std::pow(h, p) * std::pow(h_dot, q);
  };
  // One Gauss-Legendre panel per half turn or decay time, until exp(-(p+q) c t / 2) is below 1e-18.
  const double panel = std::min(std::numbers::pi / w, 2 / c);
  const double t_end = 2 * 41.5 / (c * (p + q));
  double integral = 0;
  for (double t = 0; t < t_end; t += panel) {
    integral += boost::math::quadrature::gauss<double, 30>::integrate(response, t, t + panel);
  }
  const double of_noise = p + q == 2 ? problem.noise.intensity : 0;
  return (problem.impulses.rate_moment(p + q) + of_noise) * integral;
}

}  // namespace fpkcheck::exact
