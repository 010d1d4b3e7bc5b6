#include "exact/energy_law.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

#include "base/input_error.hpp"
#include "problem/motion_scales.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::exact {
namespace {

template <class Add>
void for_each_node(double from, double to, int count, const Add& add) {
  using Gauss = boost::math::quadrature::gauss<double, 20>;
  const double half = (to - from) / count / 2;
  for (int n = 0; n < count; ++n) {
    const double centre = from + (2 * n + 1) * half;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
      add(centre - half * Gauss::abscissa()[i], half * Gauss::weights()[i]);
      add(centre + half * Gauss::abscissa()[i], half * Gauss::weights()[i]);
    }
  }
}

}  // namespace

EnergyLaw::EnergyLaw(const problem::Problem& problem)
    : potential_(effective_potential_polynomial(problem)) {
  const problem::System& system = problem.system;
  for (const auto& wall : {system.left_wall(), system.right_wall()}) {
    if (wall && wall->restitution != 1) {
      throw InputError("restitution < 1: no exact density is known for impacts with losses");
    }
  }
  const auto& damping = system.damping_polynomial();
  const bool is_nonlinear = damping.degree() > 0 || system.rayleigh_coefficient() != 0;
  const bool depends_on_energy_only =
      damping.coefficient(1) == 0 && system.has_linear_force() &&
      damping.coefficient(2) == system.stiffness() * system.rayleigh_coefficient() &&
      problem.impulses.rate_times_moment(1) == 0;
  if (is_nonlinear && !depends_on_energy_only)
    throw InputError("the damping is not a function of the energy");
  const double diffusion = total_excitation_intensity(problem) / 2;
  linear_ = damping.coefficient(0) / diffusion;
  quadratic_ = system.rayleigh_coefficient() / diffusion;

  constexpr int kPanels = 40;
  constexpr double kMarginFraction = 0.3;
  const problem::MotionScales scales = problem::motion_scales(problem);
  const double beyond = kMarginFraction * (scales.y_high - scales.y_low);
  y_low_ = system.left_wall() ? system.left_wall()->position : scales.y_low - beyond;
  y_high_ = system.right_wall() ? system.right_wall()->position : scales.y_high + beyond;
  const double v_high = (1 + kMarginFraction) * scales.v_high;
  // No points beyond the scales of the motion, even if the wall is farther away.
  for_each_node(std::max(y_low_, scales.y_low - beyond), std::min(y_high_, scales.y_high + beyond),
                kPanels, [&](double at, double weight) {
                  y_.push_back({at, weight});
                });
  for_each_node(-v_high, v_high, kPanels, [&](double at, double weight) {
    v_.push_back({at, weight});
  });
  const auto exponent = [&](double y, double v) {
    const double h = v * v / 2 + potential_(y);
    return linear_ * h + quadratic_ * h * h;
  };
  min_exponent_ = std::numeric_limits<double>::infinity();
  for (const auto& y : y_) {
    for (const auto& v : v_) min_exponent_ = std::min(min_exponent_, exponent(y.at, v.at));
  }
  norm_ = moment(0, 0);
}

double EnergyLaw::unnormalised(double y, double v) const {
  if (y < y_low_ || y > y_high_) return 0;
  const double h = v * v / 2 + potential_(y);
  return std::exp(min_exponent_ - linear_ * h - quadratic_ * h * h);
}

double EnergyLaw::operator()(double y, double v) const { return unnormalised(y, v) / norm_; }

double EnergyLaw::displacement_marginal(double y) const {
  double sum = 0;
  for (const auto& v : v_) sum += v.weight * unnormalised(y, v.at);
  return sum / norm_;
}

double EnergyLaw::velocity_marginal(double v) const {
  double sum = 0;
  for (const auto& y : y_) sum += y.weight * unnormalised(y.at, v);
  return sum / norm_;
}

double EnergyLaw::moment(int p, int q) const {
  double sum = 0;
  for (const auto& y : y_) {
    double row = 0;
    for (const auto& v : v_) row += v.weight * std::pow(v.at, q) * unnormalised(y.at, v.at);
    sum += y.weight * std::pow(y.at, p) * row;
  }
  return sum / norm_;
}

}  // namespace fpkcheck::exact
