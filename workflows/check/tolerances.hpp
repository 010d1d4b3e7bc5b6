#pragma once

#include <cstddef>
#include <optional>

#include "transform/solution.hpp"
#include "workflows/check/compared_quantity.hpp"

/// Tolerances of `fpkcheck check`. In this file, a simulation is any solution that states standard
/// errors.
namespace fpkcheck::check {

/// Tolerances of changes between two runs. The default tolerances of `fpkcheck check` follow from
/// the measurements in docs/checking.md.
struct BaselineCheckTolerances {
  /// Tolerance for deterministic quantities: relative for moments, absolute for mass and energy
  /// residual, and as a fraction of the peak for densities. The tolerance of distances between
  /// densities is in standard deviations of the variable. Rounding errors change deterministic
  /// quantities by up to 6e-11.
  double deterministic = 1e-8;
  /// Tolerance for simulations, in standard errors of the difference between the two compared runs.
  /// The standard errors of a quantity in the two compared runs are combined in quadrature.
  double standard_errors = 4;

  /// Relative tolerance for the coefficients of a closure. Rounding errors change small
  /// coefficients of the formulation `moment` by up to 1.5e-7.
  double coefficient_tolerance() const { return 50 * deterministic; }
  /// Absolute tolerance for tail distances, the mean |log10| differences in a decade of the tail.
  /// For densities of 1e-6 of the peak, rounding errors change tail distances by up to 3e-8.
  double tail_tolerance() const { return 100 * deterministic; }
  /// Returns the Bonferroni-adjusted threshold for n = `comparison_count` comparisons, in standard
  /// errors. The largest of n standard normal numbers exceeds the adjusted threshold with the
  /// probability that a single standard normal number exceeds `standard_errors`.
  double bonferroni_threshold(std::size_t comparison_count) const;
};

/// @throws InputError with the name of the option whose value is not a positive number
void validate(const BaselineCheckTolerances& tolerances);

/// Path of the metric with the number of independent streams of a simulation.
inline constexpr const char* kStreamsMetric = "streams";
/// Path of the metric that states whether a simulation was interrupted.
inline constexpr const char* kInterruptedMetric = "interrupted";

/// Returns whether two solutions are simulations that differ in a moment or in the standard error
/// of a moment. Simulations with the same seed on the same machine are identical.
bool have_independent_sampling_errors(const transform::Solution& one,
                                      const transform::Solution& other);

/// Returns the standard error sqrt((q + 1/n) / n) of the mass of a simulation, where q = 1 - mass
/// is the fraction of the samples outside the bins, and n the number of effectively independent
/// samples. The term 1/n in the standard error of the mass allows for one additional sample outside
/// the bins. For a simulation without stated sampling error the standard error of the mass is NaN.
double standard_error_of_mass(const transform::Solution& solution);

/// Changes the kind of a compared quantity to `simulated_l1`, and derives its tolerance from the
/// sampling error of a simulation. Without a known sampling error the compared quantity remains
/// unchanged.
void set_tolerance_from_sampling_error(
    CheckedQuantity& quantity, const std::optional<transform::MarginalSamplingErrors>& sampling,
    transform::StateVariable variable, const BaselineCheckTolerances& tolerances);

/// Returns the tolerance of the change of a power of a standard error between two runs, expressed
/// as the ratio minus 1. A standard error from n independent streams of a simulation has the
/// relative standard deviation 1 / sqrt(2 (n - 1)). The ratio of two standard errors, each from n
/// independent streams, has the relative standard deviation 1 / sqrt(n - 1).
/// @param number_of_errors number of compared standard errors; the tolerance applies to the largest
///        of their changes
double standard_error_change_tolerance(const transform::Solution& simulation,
                                       std::size_t number_of_errors, double power,
                                       const BaselineCheckTolerances& tolerances);

}  // namespace fpkcheck::check
