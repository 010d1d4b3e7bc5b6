#include "problem/impulse_train.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/input_error.hpp"
#include "problem/magnitude.hpp"

namespace fpkcheck::problem {
namespace {

ImpulseLaw law_of(const ImpulseParameters& parameters) {
  const auto& [rate, law, intensity, mean] = parameters;
  if (!std::isfinite(rate) || rate <= 0) {
    throw InputError(fmt::format("impulse.rate = {} (must be a positive number)", rate));
  }
  if (!std::isfinite(intensity) || intensity <= 0) {
    throw InputError(fmt::format("impulse.intensity = {} (must be a positive number)", intensity));
  }
  require_magnitude("impulse.rate", rate);
  require_magnitude("impulse.intensity", intensity);
  require_magnitude("impulse.mean", mean);
  const double variance = intensity / rate - mean * mean;
  if (!std::isfinite(mean) || variance <= 0) {
    throw InputError(fmt::format(
        "impulse.mean = {} (its square must be below impulse.intensity / impulse.rate = {:.6g}, "
        "which is E[Y^2])",
        mean, intensity / rate));
  }
  return ImpulseLaw::named(law, mean, std::sqrt(variance));
}

}  // namespace

ImpulseTrain::ImpulseTrain(const ImpulseParameters& parameters)
    : arrival_rate_(parameters.arrival_rate), law_(law_of(parameters)) {}

}  // namespace fpkcheck::problem
