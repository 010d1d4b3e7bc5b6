#include "problem/system.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/input_error.hpp"
#include "problem/magnitude.hpp"

namespace fpkcheck::problem {
namespace {

void require(bool holds, const char* key, double value, const char* allowed) {
  if (!holds) {
    throw InputError(fmt::format("system.{} = {} ({})", key, value, allowed));
  }
}

}  // namespace

System::System(const SystemCoefficients& coefficients) : c_(coefficients) {
  require(std::isfinite(c_.damping) && c_.damping > 0, "damping", c_.damping,
          "must be a positive number: without damping there is no stationary density");
  require(std::isfinite(c_.cubic) && c_.cubic >= 0, "cubic", c_.cubic,
          "must be zero or positive: a softening spring has no stationary density");
  require(std::isfinite(c_.stiffness) && c_.stiffness >= 0, "stiffness", c_.stiffness,
          "must be zero or positive");
  require(c_.stiffness > 0 || c_.cubic > 0, "stiffness", c_.stiffness,
          "must be positive when system.cubic is zero: nothing else holds the mass");
  require(c_.restitution > 0 && c_.restitution <= 1, "restitution", c_.restitution,
          "must be above 0 and at most 1");
  require_magnitude("system.damping", c_.damping);
  require_magnitude("system.stiffness", c_.stiffness);
  require_magnitude("system.cubic", c_.cubic);
  require_magnitude("system.restitution", c_.restitution);
}

}  // namespace fpkcheck::problem
