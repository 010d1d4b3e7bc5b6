#pragma once

#include <optional>
#include <string>

#include "base/options/description.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {

/// Formulas of the time t, from the section [time] of a case file.
struct TimeFormulas {
  std::optional<std::string> rate = {};       ///< factor a(t) of the rate of impulses
  std::optional<std::string> intensity = {};  ///< factor b(t) of the noise intensity
  std::optional<std::string> force = {};      ///< external force F(t)
};

const base::Description<TimeFormulas>& time_parameter_description();

/// The part of an excitation that changes in time: impulses arrive at the rate lambda a(t), the
/// noise has the intensity 2D b(t), and a deterministic force F(t) acts on the mass,
///
///     y'' + f(y, y') + g(y) = xi(t) + F(t).
///
/// The densities over time then follow from the equations of the constant excitation with these
/// factors, and with the additional term -F(t) dp/dv.
class TimeDependence {
 public:
  /// Constant excitation: a = b = 1, F = 0.
  TimeDependence() = default;
  /// @param constants named constants of the formulas, section [parameters]
  /// @throws InputError for an invalid formula
  TimeDependence(const TimeFormulas& formulas, const NamedConstants& constants);

  const TimeFormulas& formulas() const { return formulas_; }
  bool is_present() const { return rate_ || intensity_ || force_; }
  bool has_rate() const { return rate_.has_value(); }
  bool has_intensity() const { return intensity_.has_value(); }
  bool has_force() const { return force_.has_value(); }

  double rate_factor(double t) const { return rate_ ? value(*rate_, t) / rate_unit_ : 1; }
  double intensity_factor(double t) const {
    return intensity_ ? value(*intensity_, t) / intensity_unit_ : 1;
  }
  /// Returns the force in the coordinates of the problem.
  double force(double t) const { return force_ ? sign_ * value(*force_, t) : 0; }

  /// @param sign -1 for mirrored coordinates, in which the force has the opposite sign
  TimeDependence with_force_of_sign(double sign) const;
  /// Returns the same functions with the factors divided by the given numbers.
  TimeDependence with_factors_divided_by(double rate, double intensity) const;

 private:
  static double value(const Expression& formula, double t) { return formula(t, 0.0); }

  TimeFormulas formulas_;
  std::optional<Expression> rate_, intensity_, force_;
  double rate_unit_ = 1, intensity_unit_ = 1, sign_ = 1;
};

struct Problem;

/// The times 0 .. `until` of a computation. If `periodic`, they are a period of the excitation, and
/// the state is the periodic one.
struct TimeSpan {
  double until;
  bool periodic = false;
};

/// Returns the problem whose rate of impulses and noise intensity are the largest of the time span.
/// The factors of the result are relative to these values, at most 1 up to the distance of 4096
/// sampled times. The constant excitation of the result bounds boxes, grids and scales of motion.
/// @throws InputError if a factor is negative or 0 throughout, a function is not finite, a periodic
/// excitation is constant or has another period, or the largest excitation has no stationary
/// density
Problem with_largest_excitation(const Problem& problem, const TimeSpan& span);

/// Returns the problem with the constant rate of impulses and noise intensity of the time t,
/// without the force F.
Problem with_excitation_at_time(const Problem& problem, double t);

/// Largest distance from the equilibrium, largest speed, and largest sqrt(2 H) of a motion with the
/// energy H above that of the equilibrium.
struct MotionExtent {
  double displacement = 0, speed = 0, amplitude = 0;
};

/// Returns the extent of the motion under the force F(t) alone, from rest at the centre of
/// MotionScales until the end of the time span; without a force F all extents are 0. A periodic
/// motion is followed over several decay times of the slowest mode.
MotionExtent forced_motion_extent(const Problem& problem, const TimeSpan& span);

}  // namespace fpkcheck::problem
