#pragma once

#include <optional>

#include "transform/solution.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// Tolerances for those differences between two runs of a simulation that sampling errors explain.
/// In this file a simulation is any solution that states standard errors.
namespace fpkcheck::check {

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
