#include "problem/system.hpp"

#include "problem/magnitude.hpp"
#include "problem/restitution_range.hpp"

namespace fpkcheck::problem {

using namespace base;

const Description<SystemCoefficients>& system_description() {
  using C = SystemCoefficients;
  static const auto description =
      Description<C>("system.")
          .add("damping", &C::damping, {"C", "damping"}, any_number())
          .with_symbol("c", "c")
          .add("van_der_pol", &C::van_der_pol, {"C", "damping that grows with y^2"}, any_number())
          .with_symbol("c_yy", "c_yy")
          .without_naming(0.0)
          .add("rayleigh", &C::rayleigh, {"C", "damping that grows with y'^2"}, any_number())
          .with_symbol("c_vv", "c_vv")
          .without_naming(0.0)
          .add("constant", &C::constant, {"G", "constant restoring force"}, any_number())
          .with_symbol("g0", "g₀")
          .without_naming(0.0)
          .add("stiffness", &C::stiffness, {"K", "stiffness"}, any_number())
          .with_symbol("k", "k")
          .add("quadratic", &C::quadratic, {"K2", "quadratic stiffness"}, any_number())
          .with_symbol("k2", "k₂")
          .without_naming(0.0)
          .add("cubic", &C::cubic, {"MU", "cubic stiffness"}, any_number())
          .with_symbol("mu", "μ")
          .with_fallback(0.0)
          .add("quintic", &C::quintic, {"K5", "quintic stiffness"}, any_number())
          .with_symbol("k5", "k₅")
          .without_naming(0.0)
          .add("restitution", &C::restitution, {"R", "coefficient of restitution"},
               restitution_range())
          .with_symbol("r", "r")
          .without_naming(Value());
  return description;
}

namespace {

const SystemCoefficients& checked(const SystemCoefficients& coefficients) {
  system_description().validate(coefficients);
  require_magnitudes(system_description(), coefficients);
  return coefficients;
}

}  // namespace

System::System(const SystemCoefficients& coefficients, const WallParameters& walls)
    : c_(checked(coefficients)),
      wall_parameters_(walls),
      walls_(walls_of(walls, coefficients.restitution)),
      force_({c_.constant, c_.stiffness, c_.quadratic, c_.cubic, 0, c_.quintic}),
      tangent_(force_.derivative()),
      potential_(force_.antiderivative()),
      damping_({c_.damping, 0, c_.van_der_pol}) {}

System System::seen_from(const Frame& frame) const {
  if (frame.is_identity()) return *this;
  System seen = *this;
  const auto moved = [&](std::optional<Wall> wall) {
    if (wall) wall->position = frame.x(wall->position) + 0.0;  // avoids -0
    return wall;
  };
  seen.walls_ = {.left = moved(frame.mirrored ? walls_.right : walls_.left),
                 .right = moved(frame.mirrored ? walls_.left : walls_.right)};
  seen.force_ = force_.of_shifted(frame.origin, frame.sign()).times(frame.sign());
  seen.tangent_ = seen.force_.derivative();
  seen.potential_ = seen.force_.antiderivative();
  seen.damping_ = damping_.of_shifted(frame.origin, frame.sign());
  return seen;
}

}  // namespace fpkcheck::problem
