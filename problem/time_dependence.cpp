#include "problem/time_dependence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/input_error.hpp"
#include "problem/effective_potential.hpp"
#include "problem/motion_scales.hpp"
#include "problem/parameter_ranges.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

using namespace base;

const OptionsDescription<ExcitationTimeFormulas>& time_parameter_description() {
  static const Value nothing;
  static const auto description =
      OptionsDescription<ExcitationTimeFormulas>("time.")
          .add("rate", &ExcitationTimeFormulas::rate,
               {"A", "factor a(t) of impulse.rate over time, as a formula"})
          .with_symbol("a(t)", "a(t)")
          .with_default_omitted_from_files(nothing)
          .add("intensity", &ExcitationTimeFormulas::intensity,
               {"B", "factor b(t) of noise.intensity over time, as a formula"})
          .with_symbol("b(t)", "b(t)")
          .with_default_omitted_from_files(nothing)
          .add("force", &ExcitationTimeFormulas::force, {"F", "external force F(t), as a formula"})
          .with_symbol("F(t)", "F(t)")
          .with_default_omitted_from_files(nothing);
  return description;
}

ExcitationTimeDependence::ExcitationTimeDependence(const ExcitationTimeFormulas& formulas,
                                                   const NamedConstants& constants)
    : formulas_(formulas) {
  const auto parse = [&](const std::optional<std::string>& text, const char* key) {
    return text ? std::optional(Expression::parse(*text, constants, key, "t")) : std::nullopt;
  };
  rate_ = parse(formulas.rate, "time.rate");
  intensity_ = parse(formulas.intensity, "time.intensity");
  force_ = parse(formulas.force, "time.force");
}

ExcitationTimeDependence ExcitationTimeDependence::with_force_sign(double sign) const {
  ExcitationTimeDependence changed = *this;
  changed.sign_ = sign;
  return changed;
}

ExcitationTimeDependence ExcitationTimeDependence::with_factors_divided_by(
    double rate_divisor, double intensity_divisor) const {
  ExcitationTimeDependence changed = *this;
  changed.rate_unit_ *= rate_divisor;
  changed.intensity_unit_ *= intensity_divisor;
  return changed;
}

namespace {

constexpr int kSampledTimes = 4096;

// Returns the sampled time with the index k = 0 .. kSampledTimes in the time span from 0 to
// `until`. The sampled times with an even index k are equidistant. The sampled times with an odd
// index k are multiples of the golden ratio modulo 1, in units of `until`, so that the distances
// between sampled times have no period.
double sampled_time(int k, double until) {
  return k % 2 == 0 ? until * k / kSampledTimes : until * std::fmod(k * std::numbers::phi, 1.0);
}

// Returns the largest value of a function of time between 0 and `until`.
template <class Function>
double largest_value(const char* key, const Function& function, double until) {
  double largest = -HUGE_VAL;
  for (int k = 0; k <= kSampledTimes; ++k) {
    const double t = sampled_time(k, until), value = function(t);
    if (!std::isfinite(value)) {
      throw InputError(fmt::format(
          "{} is not finite at t = {:.4g}; choose a formula that is finite up to t = {:g}", key, t,
          until));
    }
    largest = std::max(largest, value);
  }
  return largest;
}

// Returns the largest value of a factor between 0 and `until`.
// @throws InputError if the factor is negative at a sampled time, or 0 at all sampled times
template <class Function>
double largest_factor(const char* key, const Function& factor, double until) {
  const auto not_negative = [&](double t) {
    const double value = factor(t);
    if (value < 0) {
      throw InputError(
          fmt::format("{} = {:.4g} at t = {:.4g} (must not be negative)", key, value, t));
    }
    return value;
  };
  const double largest = largest_value(key, not_negative, until);
  if (largest == 0) {
    throw InputError(fmt::format(
        "{} is 0 at all {} sampled times from t = 0 to t = {:g}; choose a factor above 0, or longer "
        "pulses",
        key, kSampledTimes, until));
  }
  return largest;
}

// Requires that rate, noise intensity and force of the excitation have the period `period`.
void require_excitation_period(const ExcitationTimeDependence& time, double period) {
  if (!time.is_acting()) {
    throw InputError(
        "--periodic: the excitation is constant; add the section [time], or omit --periodic");
  }
  const auto require = [&](const char* key, const auto& function) {
    // The tolerance accepts a period of the excitation that is given with five digits. At most
    // kMostJumps sampled values may differ from the values one period later, since rounding at a
    // jump may give the value on the other side of the jump.
    constexpr double kTolerance = 1e-4;
    constexpr int kMostJumps = kSampledTimes / 100;
    const double largest = largest_value(
        key, [&](double t) { return std::abs(function(t)); }, period);
    int differences = 0;
    for (int k = 0; k < kSampledTimes; ++k) {
      const double t = sampled_time(k, period);
      if (std::abs(function(t + period) - function(t)) <= kTolerance * largest) continue;
      if (++differences <= kMostJumps) continue;
      throw InputError(fmt::format(
          "{} does not have the period {:.10g}: its values are {:.8g} at t = {:.4g} and {:.8g} one "
          "period later; give its period as --until",
          key, period, function(t), t, function(t + period)));
    }
  };
  require("time.rate", [&](double t) { return time.rate_factor(t); });
  require("time.intensity", [&](double t) { return time.intensity_factor(t); });
  require("time.force", [&](double t) { return time.external_force(t); });
}

void require_magnitude(const char* key, const char* quantity, double magnitude) {
  if (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude) return;
  throw InputError(fmt::format("{}: the largest {} is {:.3g} (must be {:g} .. {:g})", key, quantity,
                               magnitude, kSmallestMagnitude, kLargestMagnitude));
}

}  // namespace

Problem with_largest_excitation(const Problem& problem, const TimeSpan& span) {
  const ExcitationTimeDependence& time = problem.time;
  if (span.periodic) require_excitation_period(time, span.until);
  if (!time.is_acting()) return problem;
  const double rate = largest_factor(
      "time.rate", [&](double t) { return time.rate_factor(t); }, span.until);
  const double intensity = largest_factor(
      "time.intensity", [&](double t) { return time.intensity_factor(t); }, span.until);
  const double force = largest_value(
      "time.force", [&](double t) { return std::abs(time.external_force(t)); }, span.until);
  if (force > 0) require_magnitude("time.force", "force", force);
  Problem strongest = problem;
  if (time.has_rate_factor()) {
    require_magnitude("time.rate", "rate of impulses", rate * problem.impulses.arrival_rate());
    require_magnitude("time.rate", "intensity of impulses", rate * problem.impulses.intensity());
    strongest.impulses = problem.impulses.with_rate_multiplied_by(rate);
  }
  if (time.has_intensity_factor()) {
    require_magnitude("time.intensity", "noise intensity", intensity * problem.noise.intensity);
    strongest.noise.intensity *= intensity;
  }
  strongest.time = time.with_factors_divided_by(rate, intensity);
  if (problem.frame.is_identity()) require_stationary_density(strongest);
  return strongest;
}

Problem with_excitation_at_time(const Problem& problem, double t) {
  if (!problem.time.is_acting()) return problem;
  Problem at_time = problem;
  if (const double rate = problem.time.rate_factor(t); rate == 0) {
    at_time = without_impulses(std::move(at_time));
  } else if (problem.impulses.is_acting()) {
    at_time.impulses = problem.impulses.with_rate_multiplied_by(rate);
  }
  at_time.noise.intensity *= problem.time.intensity_factor(t);
  at_time.time = {};
  return at_time;
}

MotionExtent forced_motion_extent(const Problem& problem, const TimeSpan& span) {
  if (!problem.time.has_external_force()) return {};
  const MotionScales motion = motion_scales(problem);
  const System& system = problem.system;
  const EffectivePotential potential(system);
  // A time step of the forced motion is 1/50 radian of the local frequency, since an extent of the
  // motion accurate to 1 % suffices. The integration of the forced motion ends after kMostSteps
  // steps.
  constexpr double kStep = 0.02, kDecayTimes = 5;
  constexpr int kMostSteps = 1000000;
  const double end =
      span.periodic ? span.until + kDecayTimes / motion.slowest_decay_rate : span.until;
  const double at_rest = potential(motion.centre), force_at_rest = system.force(motion.centre, 0);
  double y = motion.centre, v = 0, t = 0;
  MotionExtent extent;
  const auto acceleration = [&](double at, double at_y, double at_v) {
    return problem.time.external_force(at) - system.force(at_y, at_v);
  };
  for (int n = 0; n < kMostSteps && t < end; ++n) {
    const double stiffness =
        y == motion.centre ? 0 : (system.force(y, v) - force_at_rest) / (y - motion.centre);
    const double frequency = std::max(motion.frequency, std::sqrt(std::abs(stiffness)));
    const double step = std::min(kStep / frequency, end - t);
    // Heun's method
    const double a = acceleration(t, y, v);
    const double y_end = y + step * v, v_end = v + step * a;
    const double b = acceleration(std::min(t + step, end), y_end, v_end);
    y += step * (v + v_end) / 2;
    v += step * (a + b) / 2;
    t += step;
    if (const auto& wall = system.left_wall(); wall && y < wall->position) {
      y = wall->position;
      if (v < 0) v *= -wall->restitution_at_speed(-v);
    }
    if (const auto& wall = system.right_wall(); wall && y > wall->position) {
      y = wall->position;
      if (v > 0) v *= -wall->restitution_at_speed(v);
    }
    if (!std::isfinite(y) || !std::isfinite(v)) {
      throw InputError(
          fmt::format("under time.force = {} the motion is unbounded; reduce the force",
                      *problem.time.time_formulas().force));
    }
    extent.displacement = std::max(extent.displacement, std::abs(y - motion.centre));
    extent.speed = std::max(extent.speed, std::abs(v));
    extent.amplitude =
        std::max(extent.amplitude, std::sqrt(v * v + 2 * std::max(0.0, potential(y) - at_rest)));
  }
  return extent;
}

}  // namespace fpkcheck::problem
