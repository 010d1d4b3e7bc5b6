#pragma once

#include <cstddef>
#include <optional>

#include "transform/solution.hpp"
#include "workflows/check/quantity.hpp"

/// Tolerances for those differences between two runs of a simulation that sampling errors explain.
/// In this file a simulation is any solution that states standard errors.
namespace fpkcheck::check {

/// Tolerances for the change of a quantity between two runs. docs/checking.md has the measurements
/// from which the values of these tolerances follow.
struct Tolerances {
  /// Tolerance for deterministic quantities: relative for moments, absolute for mass and energy
  /// residual, relative to the peak for densities, in units of the standard deviation of the
  /// variable for distances. Rounding errors change such quantities by up to 6e-11.
  double deterministic = 1e-8;
  /// Tolerance for simulations in standard errors of the difference, which combine the standard
  /// errors of both runs in quadrature.
  double standard_errors = 4;

  /// Relative tolerance for the coefficients of a closure: rounding errors change small
  /// coefficients of the formulation `moment` by up to 1.5e-7.
  double coefficient_tolerance() const { return 50 * deterministic; }
  /// Absolute tolerance for the mean |log10| difference in a decade of the tail: for densities of
  /// 1e-6 of the peak, rounding errors change this difference by up to 3e-8.
  double tail_tolerance() const { return 100 * deterministic; }
  /// The Bonferroni-adjusted threshold for n comparisons: the largest of n standard normal numbers
  /// exceeds this threshold as rarely as a single number exceeds `standard_errors`.
  double bonferroni_threshold(std::size_t n) const;
};

/// @throws InputError naming the option whose value is not a positive number
void validate(const Tolerances& tolerances);

/// Paths of two metrics of simulations: the number of independent streams from which the standard
/// errors are estimated, and whether the simulation was interrupted before its end.
inline constexpr const char* kStreams = "streams";
inline constexpr const char* kInterrupted = "interrupted";

/// Whether both solutions are simulations and differ in a moment or in the standard error of a
/// moment. Two simulations with the same seed on the same machine are identical: for such
/// simulations the result is false.
bool differs_by_sampling(const transform::Solution& one, const transform::Solution& other);

/// The standard error of the mass of a simulation. The fraction of the samples outside the bins is
/// q = 1 - mass. With n effectively independent samples the standard error is sqrt((q + 1/n) / n),
/// where 1/n allows for one more sample outside the bins. The standard error of the mass is NaN if
/// the simulation states no sampling error.
double standard_error_of_mass(const transform::Solution& solution);

/// Changes the kind of a quantity to `simulated_l1`, with a tolerance that follows from the
/// sampling error. Without a stated sampling error the quantity is unchanged.
void set_sampling_tolerance(Quantity& quantity,
                            const std::optional<transform::SamplingError>& sampling,
                            transform::Variable variable, const Tolerances& tolerances);

/// The allowed change of error^power between two runs of a simulation, as the ratio of both runs
/// minus 1. A standard error that is estimated from n streams has the relative standard deviation 1
/// / sqrt(2 (n - 1)), and the ratio of two such standard errors has the relative standard deviation
/// 1 / sqrt(n - 1).
/// @param number_of_errors number of compared errors; the tolerance holds for the largest change
/// among these errors
double allowed_error_change(const transform::Solution& simulation, std::size_t number_of_errors,
                            double power, const Tolerances& tolerances);

}  // namespace fpkcheck::check
