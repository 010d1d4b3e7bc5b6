#include "problem/system.hpp"

#include "problem/parameter_ranges.hpp"

namespace fpkcheck::problem {

using namespace base;

const Description<SystemCoefficients>& system_parameter_description() {
  using C = SystemCoefficients;
  static const auto description =
      Description<C>("system.")
          .add("damping", &C::damping, {"C", "damping"}, finite_numbers())
          .with_symbol("c", "c")
          .add("van_der_pol", &C::van_der_pol, {"C", "damping that grows with y^2"},
               finite_numbers())
          .with_symbol("c_yy", "c_yy")
          .with_default_omitted_from_files(0.0)
          .add("rayleigh", &C::rayleigh, {"C", "damping that grows with y'^2"}, finite_numbers())
          .with_symbol("c_vv", "c_vv")
          .with_default_omitted_from_files(0.0)
          .add("constant", &C::constant, {"G", "constant restoring force"}, finite_numbers())
          .with_symbol("g0", "g₀")
          .with_default_omitted_from_files(0.0)
          .add("stiffness", &C::stiffness, {"K", "stiffness"}, finite_numbers())
          .with_symbol("k", "k")
          .add("quadratic", &C::quadratic, {"K2", "quadratic stiffness"}, finite_numbers())
          .with_symbol("k2", "k₂")
          .with_default_omitted_from_files(0.0)
          .add("cubic", &C::cubic, {"MU", "cubic stiffness"}, finite_numbers())
          .with_symbol("mu", "μ")
          .with_default(0.0)
          .add("quintic", &C::quintic, {"K5", "quintic stiffness"}, finite_numbers())
          .with_symbol("k5", "k₅")
          .with_default_omitted_from_files(0.0)
          .add("restitution", &C::restitution, {"R", "coefficient of restitution"},
               restitution_range())
          .with_symbol("r", "r")
          .with_default_omitted_from_files(Value());
  return description;
}

namespace {

const SystemCoefficients& validated_coefficients(const SystemCoefficients& coefficients) {
  system_parameter_description().validate(coefficients);
  require_magnitudes_in_range(system_parameter_description(), coefficients);
  return coefficients;
}

}  // namespace

System::System(const SystemCoefficients& coefficients, const WallParameters& walls)
    : c_(validated_coefficients(coefficients)),
      wall_parameters_(walls),
      walls_(make_walls(walls, coefficients.restitution)),
      force_({c_.constant, c_.stiffness, c_.quadratic, c_.cubic, 0, c_.quintic}),
      tangent_(force_.derivative()),
      potential_(force_.antiderivative()),
      damping_({c_.damping, 0, c_.van_der_pol}) {}

System System::to_wall_coordinates(const WallFrame& frame) const {
  if (frame.is_identity()) return *this;
  System transformed = *this;
  const auto moved = [&](std::optional<Wall> wall) {
    if (wall) wall->position = frame.wall_x(wall->position) + 0.0;  // adding 0 avoids -0
    return wall;
  };
  transformed.walls_ = {.left = moved(frame.mirrored ? walls_.right : walls_.left),
                        .right = moved(frame.mirrored ? walls_.left : walls_.right)};
  transformed.force_ =
      force_.compose_affine(frame.origin, frame.sign()).multiplied_by(frame.sign());
  transformed.tangent_ = transformed.force_.derivative();
  transformed.potential_ = transformed.force_.antiderivative();
  transformed.damping_ = damping_.compose_affine(frame.origin, frame.sign());
  return transformed;
}

}  // namespace fpkcheck::problem
