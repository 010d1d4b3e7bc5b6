#include "workflows/check/chance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "workflows/check/claims.hpp"

namespace fpkcheck::check {
namespace {

using transform::Solution;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

bool moved_by_chance(const Solution& one, const Solution& other) {
  if (!one.standard_errors || !other.standard_errors) return false;
  const auto &errors = one.standard_errors->moments, &others = other.standard_errors->moments;
  return std::ranges::any_of(transform::kMoments, [&](const transform::NamedMoment& of) {
    return one.moments.*of.moment != other.moments.*of.moment ||
           errors.*of.moment != others.*of.moment;
  });
}

double error_of_mass(const Solution& solution) {
  // A histogram p_b of n samples has the expected L1 error sqrt(2/(pi n)) sum sqrt(p_b (1 - p_b)),
  // which exceeds sqrt(2/(pi n)) for many bins. Hence 1/n <= pi/2 l1^2.
  const double l1 = solution.sampling ? solution.sampling->y.value_or(kNotANumber) : kNotANumber;
  const double one_sample = std::numbers::pi / 2 * l1 * l1;
  return std::sqrt((std::abs(1 - solution.mass) + one_sample) * one_sample);
}

void move_by_sampling(Claim& claim, const std::optional<transform::SamplingError>& sampling,
                      transform::Variable variable, const Tolerances& tolerances) {
  if (!sampling) return;
  const auto error = expected(*sampling, variable);
  const auto most = in_99(*sampling, variable);
  if (!error || !most) return;
  claim.kind = FigureKind::simulated_l1;
  claim.allowed = tolerances.standard_errors;
  claim.error += *error;
  claim.in_99 += *most;
}

double allowed_scatter(const Solution& simulation, std::size_t number_of_them, double power,
                       const Tolerances& tolerances) {
  // The ratios have heavier tails than the normal law: docs/checking.md has the measurement.
  constexpr double kHeavyTails = 1.25;
  constexpr double kUsualStreams = 128;
  const double streams = number(simulation.observations, kStreams).value_or(kUsualStreams);
  const double scatter = kHeavyTails / std::sqrt(std::max(streams - 1, 1.0));
  return std::exp(power * scatter * tolerances.of_the_largest(number_of_them)) - 1;
}

}  // namespace fpkcheck::check
