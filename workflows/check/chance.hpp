#pragma once

#include <optional>

#include "transform/solution.hpp"
#include "workflows/check/claim.hpp"
#include "workflows/check/tolerances.hpp"

/// What chance alone leaves between two runs of a simulation: of a solution that states standard
/// errors.
namespace fpkcheck::check {

/// Names of observations under which any simulation may say more of itself: the number of
/// independent parts that its standard errors come from, and whether it was stopped before its end.
inline constexpr const char* kStreams = "streams";
inline constexpr const char* kInterrupted = "interrupted";

/// True where both are simulations and chance has moved one against the other; not where they came
/// to the same to the last digit, by the same seed on the same machine.
bool moved_by_chance(const transform::Solution& one, const transform::Solution& other);

/// Standard error of a simulation's mass. 1 - mass is the share of the samples outside the bins;
/// with n that are as good as independent it has the variance of a share, and one sample more may
/// always be there. NaN where it does not state its sampling.
double error_of_mass(const transform::Solution& solution);

/// Makes a claim on an L1 one that sampling moves, where it is stated.
void move_by_sampling(Claim& claim, const std::optional<transform::SamplingError>& sampling,
                      transform::Variable variable, const Tolerances& tolerances);

/// What is allowed of the error^power of a simulation, of which there are so many: ratio of the
/// runs - 1. An error from n streams scatters by 1 / sqrt(2 (n - 1)) of itself, the ratio of two by
/// sqrt(2) times that.
double allowed_scatter(const transform::Solution& simulation, std::size_t number_of_them,
                       double power, const Tolerances& tolerances);

}  // namespace fpkcheck::check
