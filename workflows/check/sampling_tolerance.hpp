#pragma once

#include <optional>

#include "transform/solution.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// Differences between two runs of a simulation that sampling errors explain. A simulation here is
/// a solution that states standard errors.
namespace fpkcheck::check {

/// Names of the metrics that every simulation may have: the number of independent streams behind
/// its standard errors, and whether the simulation was interrupted before its end.
inline constexpr const char* kStreams = "streams";
inline constexpr const char* kInterrupted = "interrupted";

/// True where both solutions are simulations and differ in a moment or its standard error. The same
/// seed on the same machine gives identical digits: then the result is false.
bool differs_by_sampling(const transform::Solution& one, const transform::Solution& other);

/// Standard error of a simulation's mass. 1 - mass is the fraction q of the samples outside the
/// bins. With n effectively independent samples the standard error is sqrt((q + 1/n) / n), where
/// 1/n allows for one more sample. NaN where the simulation states no sampling error.
double standard_error_of_mass(const transform::Solution& solution);

/// Turns the quantity into one of kind `simulated_l1`, whose tolerance follows from the sampling
/// error. Without a stated sampling error the quantity stays as it is.
void set_sampling_tolerance(Quantity& quantity,
                            const std::optional<transform::SamplingError>& sampling,
                            transform::Variable variable, const Tolerances& tolerances);

/// Allowed change of error^power between two runs of a simulation, as ratio - 1, for the largest of
/// so many errors. A standard error from n streams has the relative deviation 1 / sqrt(2 (n - 1));
/// the ratio of two has sqrt(2) times that.
double allowed_error_change(const transform::Solution& simulation, std::size_t number_of_errors,
                            double power, const Tolerances& tolerances);

}  // namespace fpkcheck::check
