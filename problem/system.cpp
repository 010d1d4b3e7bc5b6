#include "problem/system.hpp"

#include <fmt/format.h>

#include "parameters/input_error.hpp"
#include "problem/magnitude.hpp"

namespace fpkcheck::problem {

using namespace parameters;

const Description<SystemCoefficients>& system_description() {
  using C = SystemCoefficients;
  static const auto description =
      Description<C>("system.")
          .add("damping", &C::damping, {"C", "damping"},
               positive().because("without damping there is no stationary density"))
          .with_symbol("c", "c")
          .add("stiffness", &C::stiffness, {"K", "stiffness"}, not_negative())
          .with_symbol("k", "k")
          .add("cubic", &C::cubic, {"MU", "cubic stiffness"},
               not_negative().because("a softening spring has no stationary density"))
          .with_symbol("mu", "μ")
          .add("restitution", &C::restitution, {"R", "coefficient of restitution"},
               Range{[](double r) { return r > 0 && r <= 1; }, "above 0 and at most 1"})
          .with_symbol("r", "r");
  return description;
}

System::System(const SystemCoefficients& coefficients)
    : c_(coefficients),
      force_({0, c_.stiffness, 0, c_.cubic}),
      tangent_(force_.derivative()),
      potential_(force_.antiderivative()) {
  system_description().validate(c_);
  if (force_.degree() == 0) {
    throw InputError(
        "system.stiffness = 0 (must be positive when system.cubic is zero: nothing else holds the "
        "mass)");
  }
  require_magnitudes(system_description(), c_);
}

}  // namespace fpkcheck::problem
