#include "exact/closed_forms.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "base/input_error.hpp"

namespace fpkcheck::exact {
namespace {

void require_elastic(const problem::Problem& problem) {
  if (problem.system.restitution() != 1) {
    throw InputError("restitution < 1: no exact density is known for impacts with losses");
  }
}

}  // namespace

WhiteNoiseDensity::WhiteNoiseDensity(const problem::Problem& problem)
    : beta_(2 * problem.system.damping() / problem.impulses.intensity()),
      mean_force_(problem.impulses.rate_times_moment(1)),
      potential_(problem.system.potential()) {
  require_elastic(problem);
  boost::math::quadrature::exp_sinh<double> integrate;
  displacement_norm_ = 1;
  displacement_norm_ = integrate.integrate([this](double y) { return displacement_marginal(y); });
}

double WhiteNoiseDensity::operator()(double x1, double x2) const {
  // The two halves of the (z, z') plane have equal mass.
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
  // The squared frequency; negative for overdamped motion.
  const double w2 = problem.system.stiffness() - c * c / 4;
  const bool has_wall = problem.system.left_wall() || problem.system.right_wall();
  const auto& impulses = problem.impulses;
  const bool symmetric =
      impulses.rate_times_moment(1) == 0 && impulses.amplitude_law().is_symmetric();
  if (!problem.system.has_linear_force() || problem.system.stiffness() <= 0 ||
      (has_wall && !symmetric)) {
    throw InputError(
        "no exact cumulants: requires a linear oscillator, and a symmetric law if there is a wall");
  }
  const double w = std::sqrt(std::abs(w2));
  const double slowest_rate = w2 < 0 ? problem.system.stiffness() / (c / 2 + w) : c / 2;
  const auto response = [&](double t) {
    // e^(-ct/2) times sin(wt)/w and cos(wt); sinh and cosh if overdamped; t and 1 if critical.
    double sine = std::exp(-c * t / 2) * t, cosine = std::exp(-c * t / 2);
    if (w2 > 0) {
      sine = std::exp(-c * t / 2) * std::sin(w * t) / w;
      cosine *= std::cos(w * t);
    } else if (w2 < 0) {
      const double slow = std::exp(-slowest_rate * t), fast = std::exp(-(c / 2 + w) * t);
      sine = (slow - fast) / (2 * w);
      cosine = (slow + fast) / 2;
    }
    return std::pow(sine, p) * std::pow(cosine - c / 2 * sine, q);
  };
  // A Gauss-Legendre panel for each half-cycle or shortest decay time, until
  // exp(-(p+q) slowest_rate t) is below 1e-18.
  const double panel = w2 > 0 ? std::min(std::numbers::pi / w, 2 / c) : 1 / (c / 2 + w);
  const double t_end = 41.5 / (slowest_rate * (p + q));
  double integral = 0;
  for (double t = 0; t < t_end; t += panel) {
    integral += boost::math::quadrature::gauss<double, 30>::integrate(response, t, t + panel);
  }
  const double noise_intensity = p + q == 2 ? problem.noise.intensity : 0;
  return (problem.impulses.rate_times_moment(p + q) + noise_intensity) * integral;
}

}  // namespace fpkcheck::exact
