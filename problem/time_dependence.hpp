#pragma once

#include <optional>
#include <string>

#include "base/options/option_description.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {

/// Formulas of the time t, from the section [time] of a case file.
struct ExcitationTimeFormulas {
  std::optional<std::string> rate = {};       ///< factor a(t) of the rate of impulses
  std::optional<std::string> intensity = {};  ///< factor b(t) of the noise intensity
  std::optional<std::string> force = {};      ///< external force F(t)
};

const base::OptionsDescription<ExcitationTimeFormulas>& time_parameter_description();

/// The time dependence of an excitation: impulses arrive at the rate lambda a(t), the noise has the
/// intensity 2D b(t), and a deterministic force F(t) acts on the mass,
///
///     y'' + f(y, y') + g(y) = xi(t) + F(t).
///
/// The equation of the density p over time is the density equation of the constant excitation with
/// the factors a(t) of the impulse rate and b(t) of the noise intensity, and with the additional
/// term -F(t) dp/dv.
class ExcitationTimeDependence {
 public:
  /// Constructs a constant excitation, with the factors a = b = 1 of impulse rate and noise
  /// intensity and the external force F = 0.
  ExcitationTimeDependence() = default;
  /// @param constants named constants of the formulas, section [parameters]
  /// @throws InputError for an invalid formula of the time t
  ExcitationTimeDependence(const ExcitationTimeFormulas& formulas, const NamedConstants& constants);

  const ExcitationTimeFormulas& time_formulas() const { return formulas_; }
  bool is_acting() const { return rate_ || intensity_ || force_; }
  bool has_rate_factor() const { return rate_.has_value(); }
  bool has_intensity_factor() const { return intensity_.has_value(); }
  bool has_external_force() const { return force_.has_value(); }

  double rate_factor(double t) const {
    return rate_ ? evaluate_formula_at_time(*rate_, t) / rate_unit_ : 1;
  }
  double intensity_factor(double t) const {
    return intensity_ ? evaluate_formula_at_time(*intensity_, t) / intensity_unit_ : 1;
  }
  /// Returns the external force F(t) in the coordinates of the problem.
  double external_force(double t) const {
    return force_ ? sign_ * evaluate_formula_at_time(*force_, t) : 0;
  }

  /// Returns the time dependence with the external force F(t) multiplied by `sign`.
  /// @param sign 1, or -1 for mirrored coordinates, in which the force has the opposite sign
  ExcitationTimeDependence with_force_sign(double sign) const;
  /// Returns the time dependence with the factors of the impulse rate and of the noise intensity
  /// divided by the given numbers.
  ExcitationTimeDependence with_factors_divided_by(double rate_divisor,
                                                   double intensity_divisor) const;

 private:
  static double evaluate_formula_at_time(const Expression& formula, double t) {
    return formula(t, 0.0);
  }

  ExcitationTimeFormulas formulas_;
  std::optional<Expression> rate_, intensity_, force_;
  double rate_unit_ = 1, intensity_unit_ = 1, sign_ = 1;
};

struct Problem;

/// The time span 0 .. `until` of a computation. If `periodic` is true, the time span is one period
/// of the excitation, and the computation determines the periodic density.
struct TimeSpan {
  double until;
  bool periodic = false;
};

/// Returns the problem with the largest impulse rate and the largest noise intensity among 4096
/// times of the time span. The time-dependent factors of the returned problem are divided by their
/// largest values, so that the factors are at most 1 at the sampled times. Computation domains,
/// grids and motion scales are determined from the largest excitation in the time span.
/// @throws InputError if a factor is negative or 0 throughout, a function is not finite, a periodic
/// excitation is constant or has another period, or the largest excitation has no stationary
/// density
Problem with_largest_excitation(const Problem& problem, const TimeSpan& span);

/// Returns the problem with the impulse rate and the noise intensity of the time t as constants,
/// without the external force F(t).
Problem with_excitation_at_time(const Problem& problem, double t);

/// Largest distance from the equilibrium, largest speed, and largest amplitude sqrt(2 H) of a
/// motion. The energy H of the motion is measured from the energy of the equilibrium.
struct MotionExtent {
  double displacement = 0, speed = 0, amplitude = 0;
};

/// Returns the extent of the motion under the external force F(t) alone, from rest at the centre of
/// MotionScales until the end of the time span; without an external force all extents are 0. If the
/// time span is one period of the excitation, the motion is followed over several decay times of
/// its slowest mode.
MotionExtent forced_motion_extent(const Problem& problem, const TimeSpan& span);

}  // namespace fpkcheck::problem
