#include "backward/bounds/residual_weight.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "backward/generator/impulse_mean_table.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

// Returns an upper bound of the moment E[G^(n/2)] of the energy G from upper bounds of the moments
// E[G^j] with integers j. For odd n = 2j + 1, E[G^(j+1/2)]^2 <= E[G^j] E[G^(j+1)].
numerics::Interval half_power_bound(const std::vector<numerics::Interval>& bounds, int n) {
  if (n % 2 == 0) return bounds[n / 2];
  return sqrt(bounds[n / 2] * bounds[n / 2 + 1]);
}

// Returns 2^(n/2).
numerics::Interval power_of_root_two(int n) {
  const numerics::Interval whole = std::ldexp(1.0, n >= 0 ? n / 2 : -((1 - n) / 2));
  return n % 2 == 0 ? whole : whole * sqrt(numerics::Interval(2));
}

std::vector<numerics::Interval> enclose_energy_moment_bounds(const problem::Problem& problem,
                                                             int highest_power) {
  const numerics::Interval rate = problem.impulses.arrival_rate(),
                           damping = problem.system.damping();
  // Upper bounds of the moments E[|Y|^n] of the impulse amplitude Y
  std::vector<numerics::Interval> amplitude_moments(2 * highest_power + 1);
  for (int n = 0; n <= 2 * highest_power; ++n) {
    amplitude_moments[n] = magnitude(enclose_amplitude_moment(problem.impulses.amplitude_law(), n));
  }
  // An impulse Y changes the energy G to G + w Y + Y^2/2, where w = v + c y/2 with damping c, and
  // |w| <= sqrt(2G). Hence the moments of the energy G satisfy
  //
  //   j c E[G^j] <= lambda sum_{(i,l) != (0,0)} j!/(i! l! (j-i-l)!) 2^(i/2-l) |E[Y^(i+2l)]|
  //                        E[G^(j-i/2-l)].
  //
  // The term of the sum with i = 1 and l = 0 contains E[G^(j-1/2)] <= sqrt(M_{j-1} E[G^j]) with the
  // bound M_{j-1} of E[G^(j-1)], which gives a quadratic inequality for sqrt(E[G^j]).
  std::vector<numerics::Interval> bounds{numerics::Interval(1)};
  for (int j = 1; j <= highest_power; ++j) {
    numerics::Interval constant = 0, linear = 0;
    for (int i = 0; i <= j; ++i) {
      for (int l = 0; i + l <= j; ++l) {
        if (i + l == 0) continue;
        numerics::Interval term = rate * numerics::binomial_coefficient(j, i) *
                                  numerics::binomial_coefficient(j - i, l) *
                                  amplitude_moments[i + 2 * l] * power_of_root_two(i - 2 * l);
        if (i == 1 && l == 0) {
          linear += term * sqrt(bounds[j - 1]);
        } else {
          constant += term * half_power_bound(bounds, 2 * j - i - 2 * l);
        }
      }
    }
    const numerics::Interval jc = static_cast<double>(j) * damping;
    const numerics::Interval root =
        (linear + sqrt(square(linear) + 4.0 * jc * constant)) / (2.0 * jc);
    bounds.push_back(numerics::Interval(square(root).upper()));
  }
  return bounds;
}

}  // namespace

double ResidualWeightFunctionOfEnergy::energy(double y, double v) const {
  const double w = v + damping * y / 2;
  return w * w / 2 + (stiffness - damping * damping / 4) * y * y / 2 +
         cubic_stiffness * y * y * y * y / 4;
}

double ResidualWeightFunctionOfEnergy::operator()(double y, double v) const {
  return 1 + std::pow(energy(y, v) / energy_scale, exponent);
}

std::string bounds_unsupported_reason(const problem::Problem& problem) {
  if (std::string why = problem::polynomial_method_unsupported_reason(problem); !why.empty())
    return why;
  const problem::System& system = problem.system;
  const auto& g = system.restoring_force().coefficients();
  const auto &left = system.left_wall(), &right = system.right_wall();
  if (problem.noise.is_acting() || !problem.impulses.is_acting()) {
    return "white noise is not supported: bounds are for impulses alone";
  }
  if (const auto& law = problem.impulses.amplitude_law(); !has_interval_enclosures(law)) {
    return fmt::format("{} impulses are not supported: no enclosures of the law", law.name());
  }
  if (!system.has_constant_damping() || !(system.damping() > 0)) {
    return "the damping is not supported: the weight needs constant damping c > 0";
  }
  if (g[0] != 0 || g[2] != 0 || g[3] < 0 || g[5] != 0) {
    return "the force is not supported: the weight needs k y + mu y^3 with mu >= 0";
  }
  if ((left && left->position > 0) || (right && right->position < 0)) {
    return "the spring presses the mass to a wall: impacts there increase the weight";
  }
  if (left && right && (left->restitution < 1 || right->restitution < 1)) {
    return "losses at two walls are not supported: the splines fit the impacts of one wall";
  }
  const double c = problem.system.damping(), k = problem.system.stiffness();
  const bool under_damped = numerics::call_with_upward_rounding(
      [&] { return (4.0 * numerics::Interval(k) - square(numerics::Interval(c))).lower() > 0; });
  if (under_damped) return {};
  return fmt::format("c^2 >= 4k (c = {:.6g}, k = {:.6g}): the weight needs underdamped motion", c,
                     k);
}

std::vector<double> energy_moment_bounds(const problem::Problem& problem, int highest_power) {
  assert(bounds_unsupported_reason(problem).empty());
  return numerics::call_with_upward_rounding([&] {
    std::vector<double> upper;
    for (const numerics::Interval& bound : enclose_energy_moment_bounds(problem, highest_power))
      upper.push_back(bound.upper());
    return upper;
  });
}

ResidualWeightFunctionOfEnergy make_residual_weight(const problem::Problem& problem, int exponent) {
  const double moment = energy_moment_bounds(problem, exponent).back();
  const problem::SystemCoefficients& c = problem.system.coefficients();
  ResidualWeightFunctionOfEnergy weight{
      c.damping, c.stiffness, c.cubic, exponent, std::pow(4 * moment, 1.0 / exponent), 0};
  weight.mean_upper_bound = numerics::call_with_upward_rounding([&] {
    return (1.0 + numerics::Interval(moment) /
                      numerics::power(numerics::Interval(weight.energy_scale), exponent))
        .upper();
  });
  return weight;
}

}  // namespace fpkcheck::backward
