#include "problem/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/input_error.hpp"
#include "problem/parameter_ranges.hpp"

namespace fpkcheck::problem {

using namespace base;

const OptionsDescription<SystemCoefficients>& system_parameter_description() {
  using C = SystemCoefficients;
  static const auto description =
      OptionsDescription<C>("system.")
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
          .add("force", &C::force,
               {"F", "force f(y, v) as a formula, in place of the coefficients"})
          .with_symbol("f", "f")
          .with_default_omitted_from_files(Value())
          .add("restitution", &C::restitution, {"R", "coefficient of restitution"},
               admissible_restitution_range())
          .with_symbol("r", "r")
          .with_default_omitted_from_files(Value());
  return description;
}

namespace {

struct ForceMonomial {
  int y_power, v_power;
  double SystemCoefficients::*coefficient;
};

/// The monomials y^i v^j of the force, with the coefficient of each monomial.
constexpr ForceMonomial kMonomials[] = {
    {0, 0, &SystemCoefficients::constant},    {1, 0, &SystemCoefficients::stiffness},
    {2, 0, &SystemCoefficients::quadratic},   {3, 0, &SystemCoefficients::cubic},
    {5, 0, &SystemCoefficients::quintic},     {0, 1, &SystemCoefficients::damping},
    {2, 1, &SystemCoefficients::van_der_pol}, {0, 3, &SystemCoefficients::rayleigh}};

// Requires that the coefficient of y^i v^j in a force formula is within the limits for coefficients
// of the case file.
void require_magnitude_in_range(int i, int j, double coefficient) {
  const double magnitude = std::abs(coefficient);
  if (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude) return;
  throw InputError(fmt::format(
      "system.force has the coefficient {:.3g} of y^{} v^{}: magnitudes must lie within "
      "{} .. {}; choose other units of time and length",
      coefficient, i, j, kSmallestMagnitude, kLargestMagnitude));
}

// Sets the force coefficients from a polynomial force formula; returns false if the formula
// contains a term that is not in kMonomials.
bool set_coefficients_of_formula(const Expression& formula, SystemCoefficients& c) {
  for (const ForceMonomial& term : kMonomials) c.*term.coefficient = 0;
  const auto polynomial = formula.polynomial_coefficients();
  if (!polynomial) return false;
  SystemCoefficients of_formula = c;
  for (const auto& monomial : *polynomial) {
    const auto term = std::ranges::find_if(kMonomials, [&](const ForceMonomial& known) {
      return std::pair(known.y_power, known.v_power) == monomial.first;
    });
    if (term == std::end(kMonomials)) return false;
    of_formula.*term->coefficient = monomial.second;
    require_magnitude_in_range(term->y_power, term->v_power, monomial.second);
  }
  c = of_formula;
  return true;
}

// Returns the formula of the polynomial force with the given coefficients.
Expression formula_of_coefficients(const SystemCoefficients& c) {
  std::string text = "0";
  for (const auto& [y_power, v_power, coefficient] : kMonomials) {
    if (c.*coefficient == 0) continue;
    text += fmt::format(" + ({})*y^{}*v^{}", c.*coefficient, y_power, v_power);
  }
  return Expression::parse(text, {}, "system");
}

void require_valid_coefficients(const SystemCoefficients& coefficients) {
  system_parameter_description().validate(coefficients);
  require_magnitudes_in_range(system_parameter_description(), coefficients);
}

}  // namespace

System::System(const SystemCoefficients& coefficients, const WallParameters& walls,
               const NamedConstants& constants)
    : c_(coefficients),
      wall_parameters_(walls),
      constants_(constants),
      walls_(make_walls(walls, coefficients.restitution, constants)) {
  if (c_.force) {
    Expression formula = Expression::parse(*c_.force, constants_, "system.force");
    if (!set_coefficients_of_formula(formula, c_)) {
      formula_.emplace(std::move(formula));
    }
  }
  require_valid_coefficients(c_);
  force_ = numerics::Polynomial({c_.constant, c_.stiffness, c_.quadratic, c_.cubic, 0, c_.quintic});
  tangent_ = force_.derivative();
  potential_ = force_.antiderivative();
  damping_ = numerics::Polynomial({c_.damping, 0, c_.van_der_pol});
  damping_slope_ = damping_.derivative();
}

void System::evaluate_forces(std::size_t count, const double* y, const double* v,
                             double* force) const {
  if (!formula_) {
    for (std::size_t k = 0; k < count; ++k) force[k] = damping_force(y[k], v[k]) + force_(y[k]);
    return;
  }
  formula_->evaluate_batch(count, y, v, force);
  if (sign_ == 1) return;
  for (std::size_t k = 0; k < count; ++k) force[k] *= sign_;
}

std::vector<double> System::kinks_in_y(double low, double high) const {
  return formula_ ? formula_->kinks_in_x(low, high) : std::vector<double>{};
}

std::vector<double> System::kinks_in_v(double low, double high) const {
  return formula_ ? formula_->kinks_in_v(low, high) : std::vector<double>{};
}

System System::equivalent_ito_system(const NoiseFactor& factor, double diffusion) const {
  System transformed = *this;
  if (!formula_) transformed.formula_.emplace(formula_of_coefficients(c_));
  transformed.stratonovich_factor_ = factor;
  transformed.stratonovich_diffusion_ = diffusion;
  return transformed;
}

System System::to_wall_coordinates(const WallFrame& frame) const {
  if (frame.is_identity()) return *this;
  System transformed = *this;
  const auto moved = [&](std::optional<Wall> wall) {
    if (wall) wall->position = frame.wall_coordinate(wall->position) + 0.0;  // adding 0 avoids -0
    return wall;
  };
  transformed.walls_ = {.left = moved(frame.mirrored ? walls_.right : walls_.left),
                        .right = moved(frame.mirrored ? walls_.left : walls_.right)};
  transformed.force_ = force_.compose_affine(frame.origin, frame.velocity_sign())
                           .multiplied_by(frame.velocity_sign());
  transformed.tangent_ = transformed.force_.derivative();
  transformed.potential_ = transformed.force_.antiderivative();
  transformed.damping_ = damping_.compose_affine(frame.origin, frame.velocity_sign());
  transformed.damping_slope_ = transformed.damping_.derivative();
  if (formula_) transformed.formula_ = formula_->to_wall_coordinates(frame);
  if (stratonovich_factor_) {
    transformed.stratonovich_factor_ = stratonovich_factor_->to_wall_coordinates(frame);
  }
  transformed.sign_ = frame.velocity_sign();
  return transformed;
}

}  // namespace fpkcheck::problem
