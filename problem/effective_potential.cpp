#include "problem/effective_potential.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::problem {
namespace {

struct RootSearchInterval {
  double low, high;
};

// Returns the interval in which the roots of a polynomial are searched. The ends of the search
// interval are the walls; on a side without a wall the end is a bound of all roots. For a
// polynomial of a single term, whose root is 0, root_modulus_bound() is 1, so that the search
// interval contains the root.
RootSearchInterval search_interval(const numerics::Polynomial& polynomial, const System& system) {
  const double bound = 2 * numerics::root_modulus_bound(polynomial) + 1;
  return {.low = system.left_wall() ? system.left_wall()->position : -bound,
          .high = system.right_wall() ? system.right_wall()->position : bound};
}

// Least and largest magnitude of the knots at which the potential of a force formula is tabulated.
// The knots of the tabulated potential are powers of sqrt 2 with both signs.
constexpr double kNearestKnot = 1e-12, kFarthestKnot = 1e30;
// The potential of a force formula counts as infinite above kLargestPotential.
constexpr double kLargestPotential = 1e200;

}  // namespace

std::vector<double> polynomial_sign_changes_between_walls(const numerics::Polynomial& polynomial,
                                                          const System& system) {
  const auto [low, high] = search_interval(polynomial, system);
  return low < high ? numerics::sign_change_points(polynomial, low, high) : std::vector<double>{};
}

numerics::Polynomial effective_potential_polynomial(const Problem& problem) {
  auto coefficients = problem.system.potential().coefficients();
  coefficients[1] -= problem.impulses.rate_times_moment(1);
  return numerics::Polynomial(coefficients);
}

EffectivePotential::EffectivePotential(const Problem& problem)
    : system_(problem.system), mean_force_(problem.impulses.rate_times_moment(1)) {
  if (!system_.has_polynomial_force()) {
    tabulate_potential();
    return;
  }
  polynomial_ = effective_potential_polynomial(problem);
  slope_polynomial_ = polynomial_->derivative();
  const auto [low, high] = search_interval(slope_polynomial_, system_);
  low_ = low;
  high_ = high;
  extrema_ = polynomial_sign_changes_between_walls(slope_polynomial_, system_);
  const std::size_t degree = slope_polynomial_.degree();
  const double leading = slope_polynomial_.coefficient(degree);
  is_unbounded_on_right_ = leading > 0;
  is_unbounded_on_left_ = (degree % 2 == 0 ? 1 : -1) * leading < 0;
}

EffectivePotential::EffectivePotential(const System& system)
    : EffectivePotential(Problem{.name = "", .system = system}) {}

void EffectivePotential::tabulate_potential() {
  std::set<double> knots{0};
  for (double knot = kNearestKnot; knot < kFarthestKnot; knot *= std::sqrt(2.0)) {
    knots.insert(knot);
    knots.insert(-knot);
  }
  for (const double extent : {1.0, 10.0, 100.0, 1000.0}) {
    for (const double kink : system_.kinks_in_y(-extent, extent)) knots.insert(kink);
  }
  knots_.assign(knots.begin(), knots.end());
  const auto zero = std::ranges::find(knots_, 0.0) - knots_.begin();
  values_.assign(knots_.size(), 0);
  const auto add = [&](std::size_t from, std::size_t to) {
    values_[to] = values_[from];  // integrate_force_up_to() adds the last panel
    values_[to] = integrate_force_up_to(knots_[to]);
  };
  const auto middle = static_cast<std::size_t>(zero);
  for (std::size_t n = middle + 1; n < knots_.size(); ++n) add(n - 1, n);
  for (std::size_t n = middle; n-- > 0;) add(n + 1, n);

  const auto &left = system_.left_wall(), &right = system_.right_wall();
  // Sign changes of the slope V' are searched on subdivisions of the intervals between knots.
  constexpr int kDivisions = 4;
  double before = left ? left->position : knots_.front();
  low_ = left ? left->position : -1;
  high_ = right ? right->position : 1;
  const auto inspect = [&](double y) {
    if (y <= before || (right && y > right->position)) return;
    if (potential_slope(before) * potential_slope(y) < 0) {
      extrema_.push_back(
          numerics::bracketed_root([&](double x) { return potential_slope(x); }, before, y));
    }
    if (potential_slope(y) != 0) before = y;
  };
  for (std::size_t n = 0; n + 1 < knots_.size(); ++n) {
    for (int k = 1; k <= kDivisions; ++k) {
      inspect(knots_[n] + (knots_[n + 1] - knots_[n]) * k / kDivisions);
    }
  }
  if (right) inspect(right->position);
  if (!extrema_.empty()) {
    if (!left) low_ = 2 * std::min(extrema_.front(), 0.0) - 1;
    if (!right) high_ = 2 * std::max(extrema_.back(), 0.0) + 1;
  }
  // The potential V counts as unbounded if V increases over the last octave of the knots by more
  // than rounding errors. For an unbounded potential, the mean slope over the last octave must also
  // exceed 5 standard errors of the sampled slopes, since samples do not resolve the mean of an
  // oscillating force such as sin(y).
  const auto rises = [&](double far) {
    const double at_far = integrate_force_up_to(far), before_far = integrate_force_up_to(far / 2);
    if (at_far >= kLargestPotential) return true;
    constexpr int kSamples = 200;
    double sum = 0, squares = 0;
    for (int n = 1; n <= kSamples; ++n) {
      const double fraction = std::fmod(n * std::numbers::phi, 1.0);
      const double outward = (far > 0 ? 1 : -1) * potential_slope(far * (1 + fraction) / 2);
      sum += outward;
      squares += outward * outward;
    }
    // The standard error of the mean slope is at most the root mean square / sqrt(kSamples).
    const double mean = sum / kSamples, rms = std::sqrt(squares / kSamples);
    return mean > 5 * rms / std::sqrt(kSamples) &&
           at_far - before_far > 1e-12 * std::max(1.0, std::abs(at_far));
  };
  constexpr double kFar = 1e12;
  is_unbounded_on_left_ = rises(-kFar);
  is_unbounded_on_right_ = rises(kFar);
}

double EffectivePotential::integrate_force_up_to(double y) const {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  if (y == 0) return 0;
  // The index n denotes the knot between 0 and y that is nearest to y.
  const auto after =
      y > 0 ? std::ranges::lower_bound(knots_, y) : std::ranges::upper_bound(knots_, y);
  const auto n = static_cast<std::size_t>(after - knots_.begin()) - (y > 0 ? 1 : 0);
  const std::size_t knot = std::min(n, knots_.size() - 1);
  const double panel = Gauss::integrate([&](double x) { return system_.force(x, 0) - mean_force_; },
                                        knots_[knot], y);
  const double value = values_[knot] + panel;
  return value < kLargestPotential ? value : kLargestPotential;
}

std::optional<double> rest_displacement(const Problem& problem, double y_limit,
                                        const std::optional<double>& lower_limit) {
  const System& system = problem.system;
  const auto excitation_ends_rest = [&](double rest) {
    return problem.noise.is_acting() || !problem.impulse_factor ||
           (*problem.impulse_factor)(rest, 0) != 0;
  };
  const auto& wall = system.left_wall();
  if (wall && system.force(wall->position, 0) >= 0 &&
      (!lower_limit || wall->position > *lower_limit)) {
    return excitation_ends_rest(wall->position) ? std::optional(wall->position) : std::nullopt;
  }
  const EffectivePotential potential(system);
  // Distance at which the slopes of the potential beside a minimum are compared, in units of the
  // distance between the outermost extrema of the potential.
  constexpr double kBeside = 1e-4;
  const double beside = kBeside * (potential.y_high() - potential.y_low());
  std::optional<double> rest;
  for (const double y : potential.extremum_positions()) {
    const bool is_minimum =
        potential.potential_slope(y - beside) < 0 && potential.potential_slope(y + beside) > 0;
    if (y >= y_limit || (lower_limit && y <= *lower_limit) || !is_minimum ||
        !excitation_ends_rest(y)) {
      continue;
    }
    if (!rest || potential(y) < potential(*rest)) rest = y;
  }
  return rest;
}

}  // namespace fpkcheck::problem
