#include "problem/time_dependence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/input_error.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

using namespace base;

const Description<TimeFormulas>& time_parameter_description() {
  static const Value nothing;
  static const auto description =
      Description<TimeFormulas>("time.")
          .add("rate", &TimeFormulas::rate,
               {"A", "factor a(t) of impulse.rate over time, as a formula"})
          .with_symbol("a(t)", "a(t)")
          .with_default_omitted_from_files(nothing)
          .add("intensity", &TimeFormulas::intensity,
               {"B", "factor b(t) of noise.intensity over time, as a formula"})
          .with_symbol("b(t)", "b(t)")
          .with_default_omitted_from_files(nothing)
          .add("force", &TimeFormulas::force, {"F", "external force F(t), as a formula"})
          .with_symbol("F(t)", "F(t)")
          .with_default_omitted_from_files(nothing);
  return description;
}

TimeDependence::TimeDependence(const TimeFormulas& formulas, const NamedConstants& constants)
    : formulas_(formulas) {
  const auto parse = [&](const std::optional<std::string>& text, const char* key) {
    return text ? std::optional(Expression::parse(*text, constants, key, "t")) : std::nullopt;
  };
  rate_ = parse(formulas.rate, "time.rate");
  intensity_ = parse(formulas.intensity, "time.intensity");
  force_ = parse(formulas.force, "time.force");
}

TimeDependence TimeDependence::with_force_of_sign(double sign) const {
  TimeDependence changed = *this;
  changed.sign_ = sign;
  return changed;
}

TimeDependence TimeDependence::with_factors_divided_by(double rate, double intensity) const {
  TimeDependence changed = *this;
  changed.rate_unit_ *= rate;
  changed.intensity_unit_ *= intensity;
  return changed;
}

namespace {

constexpr int kSampledTimes = 4096;

// Returns the largest value of a function of time between 0 and `until`.
template <class Function>
double largest_value(const char* key, const Function& function, double until, bool is_factor) {
  double largest = -HUGE_VAL;
  for (int k = 0; k <= kSampledTimes; ++k) {
    const double t = until * k / kSampledTimes, value = function(t);
    if (!std::isfinite(value)) {
      throw InputError(fmt::format(
          "{} is not finite at t = {:.4g}; choose a formula that is finite up to t = {:g}", key, t,
          until));
    }
    if (is_factor && value < 0) {
      throw InputError(
          fmt::format("{} = {:.4g} at t = {:.4g} (must not be negative)", key, value, t));
    }
    largest = std::max(largest, value);
  }
  if (is_factor && largest == 0) {
    throw InputError(
        fmt::format("{} is 0 from t = 0 to t = {:g}; remove the section instead", key, until));
  }
  return largest;
}

}  // namespace

Problem with_largest_excitation(const Problem& problem, double until) {
  if (!problem.time.is_present()) return problem;
  const TimeDependence& time = problem.time;
  const double rate = largest_value(
      "time.rate", [&](double t) { return time.rate_factor(t); }, until, true);
  const double intensity = largest_value(
      "time.intensity", [&](double t) { return time.intensity_factor(t); }, until, true);
  largest_value(
      "time.force", [&](double t) { return time.force(t); }, until, false);
  Problem strongest = problem;
  if (time.has_rate()) strongest.impulses = problem.impulses.with_rate_multiplied_by(rate);
  strongest.noise.intensity *= intensity;
  strongest.time = time.with_factors_divided_by(rate, intensity);
  return strongest;
}

Problem with_excitation_at_time(const Problem& problem, double t) {
  if (!problem.time.is_present()) return problem;
  Problem at_time = problem;
  if (const double rate = problem.time.rate_factor(t); rate == 0) {
    at_time.impulses = ImpulseTrain();
    at_time.impulse_factor.reset();
  } else if (problem.impulses.is_present()) {
    at_time.impulses = problem.impulses.with_rate_multiplied_by(rate);
  }
  at_time.noise.intensity *= problem.time.intensity_factor(t);
  at_time.time = {};
  return at_time;
}

MotionExtent forced_motion_extent(const Problem& problem, double until) {
  if (!problem.time.has_force()) return {};
  const MotionScales motion = scales(problem);
  const System& system = problem.system;
  // Steps of 1/50 radian; the extent is needed to 1 % only.
  constexpr double kStep = 0.02, kMostSteps = 1e6;
  const double step = std::max(kStep / motion.frequency, until / kMostSteps);
  double y = motion.centre, v = 0;
  MotionExtent extent;
  const auto acceleration = [&](double t, double at_y, double at_v) {
    return problem.time.force(t) - system.force(at_y, at_v);
  };
  for (double t = 0; t < until; t += step) {
    // Heun's method
    const double a = acceleration(t, y, v);
    const double y_end = y + step * v, v_end = v + step * a;
    const double b = acceleration(t + step, y_end, v_end);
    y += step * (v + v_end) / 2;
    v += step * (a + b) / 2;
    if (const auto& wall = system.left_wall(); wall && y < wall->position) {
      y = wall->position;
      if (v < 0) v *= -wall->restitution_at(-v);
    }
    if (const auto& wall = system.right_wall(); wall && y > wall->position) {
      y = wall->position;
      if (v > 0) v *= -wall->restitution_at(v);
    }
    if (!std::isfinite(y) || !std::isfinite(v)) {
      throw InputError(
          fmt::format("under time.force = {} the motion is unbounded; reduce the force",
                      *problem.time.formulas().force));
    }
    extent.displacement = std::max(extent.displacement, std::abs(y - motion.centre));
    extent.speed = std::max(extent.speed, std::abs(v));
  }
  return extent;
}

void require_period(const Problem& problem, double period) {
  const auto require = [&](const char* key, const auto& function) {
    // A period with five digits is accepted.
    constexpr double kTolerance = 1e-4;
    double largest = 0;
    for (int k = 0; k < kSampledTimes; ++k) {
      largest = std::max(largest, std::abs(function(period * k / kSampledTimes)));
    }
    for (int k = 0; k < kSampledTimes; ++k) {
      const double t = period * k / kSampledTimes;
      if (std::abs(function(t + period) - function(t)) <= kTolerance * largest) continue;
      throw InputError(fmt::format(
          "{} does not have the period {:.10g}: its values are {:.8g} at t = {:.4g} and {:.8g} one period later; give "
          "its period as --until",
          key, period, function(t), t, function(t + period)));
    }
  };
  require("time.rate", [&](double t) { return problem.time.rate_factor(t); });
  require("time.intensity", [&](double t) { return problem.time.intensity_factor(t); });
  require("time.force", [&](double t) { return problem.time.force(t); });
}

}  // namespace fpkcheck::problem
