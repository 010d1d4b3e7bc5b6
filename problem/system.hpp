#pragma once

#include <cassert>
#include <optional>
#include <vector>

#include "base/options/option_description.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/expression/state_function.hpp"
#include "problem/noise_factor.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::problem {

/// Coefficients of the oscillator, as read from the section [system] of a case file. All physical
/// quantities of the program are non-dimensional.
struct SystemCoefficients {
  double damping = 0;      ///< linear damping c, coefficient of y'
  double van_der_pol = 0;  ///< damping coefficient of y^2 y'
  double rayleigh = 0;     ///< damping coefficient of y'^3
  double constant = 0;     ///< restoring force at y = 0
  double stiffness = 0;    ///< linear stiffness k, coefficient of y
  double quadratic = 0;    ///< stiffness coefficient of y^2
  double cubic = 0;        ///< cubic stiffness mu, coefficient of y^3
  double quintic = 0;      ///< stiffness coefficient of y^5
  /// Formula of the force f + g, the sum of damping force f and restoring force g (Expression). If
  /// a force formula is present, the polynomial coefficients are computed from the formula.
  std::optional<std::string> force = {};
  /// Restitution coefficient r, 0 < r <= 1, of a wall at y = 0 on the left; absent if the section
  /// [wall] defines the walls.
  std::optional<double> restitution = {};
};

const base::OptionsDescription<SystemCoefficients>& system_parameter_description();

/// The oscillator of paper (1)-(2), generalised to any polynomial force of degree 5 and to two
/// walls:
///
///     y'' + f(y, y') + g(y) = xi(t)  between the walls,    y'(+) = -r y'(-)  at each wall,
///     f = y' (c(y) + c_vv y'^2),   c(y) = c + c_yy y^2,
///     g = g_0 + k y + k_2 y^2 + mu y^3 + k_5 y^5.
///
/// The oscillator of the paper has the restoring force g = k y + mu y^3, the damping force f = c y'
/// and the motion in y > 0. On the plane of the variables (z, z') of paper (5), the restoring force
/// at z < 0 is -g(-z).
class System {
 public:
  /// @param constants the named constants of the formula of the force, section [parameters]
  /// @throws InputError that states the invalid coefficient, its value and the allowed range; or
  /// the invalid part of the formula and its column
  explicit System(const SystemCoefficients& coefficients, const WallParameters& walls = {},
                  const NamedConstants& constants = {});

  /// Returns the coefficients of force and damping in physical coordinates, from the case file or
  /// its force formula, even for a system in wall coordinates.
  const SystemCoefficients& coefficients() const { return c_; }
  const WallParameters& wall_parameters() const { return wall_parameters_; }
  const NamedConstants& named_constants() const { return constants_; }

  /// Returns whether the forces f and g are polynomials of the form y' (c(y) + c_vv y'^2) and g(y),
  /// given by coefficients or by a formula. For a force formula of any other form, only the
  /// function force() describes the force.
  bool has_polynomial_force() const { return !formula_; }
  /// Returns the total force f(y, v) + g(y). Under multiplicative noise with the diffusion
  /// coefficient D G(y, v) the total force F is the force of the equation in Ito's sense: the
  /// Fokker-Planck equation for the density p has the terms (F p)_v + D (G p)_vv.
  double force(double y, double v) const {
    if (!formula_) return damping_force(y, v) + force_(y);
    double force = sign_ * (*formula_)(y, v);
    if (stratonovich_factor_) {
      force -=
          stratonovich_diffusion_ / 2 * stratonovich_factor_->squared_noise_factor_slope_in_v(y, v);
    }
    return force;
  }
  /// Returns the oscillator whose equation in Ito's sense is equivalent to the present equation in
  /// Stratonovich's sense, with noise of diffusion coefficient D and factor g. In the returned
  /// system the function force() includes the drift -D G_v / 2, where G = g^2 is the square of the
  /// noise factor.
  System equivalent_ito_system(const NoiseFactor& factor, double diffusion) const;
  /// Computes the force f(y, v) + g(y) at `count` <= Expression::kBatchPoints points, faster than
  /// by single evaluations. Under multiplicative noise evaluate_forces() computes the force of the
  /// equation in the sense of the setting noise.interpretation, without the drift D G_v / 2, where
  /// G is the square of the noise factor.
  void evaluate_forces(std::size_t count, const double* y, const double* v, double* force) const;
  /// Returns the damping force f(y, v), the part of the force that vanishes at v = 0.
  double damping_force(double y, double v) const {
    if (formula_) return force(y, v) - force(y, 0);
    return v * (damping_(y) + c_.rayleigh * v * v);
  }
  /// @pre the derivative exists at (y, v), and the noise has no factor that depends on v
  double force_slope_in_y(double y, double v) const {
    assert(!stratonovich_factor_);
    return formula_ ? sign_ * formula_->with_slope_in_x(y, v).derivative
                    : tangent_(y) + v * damping_slope_(y);
  }
  /// @pre the derivative exists at (y, v), and the noise has no factor that depends on v
  double force_slope_in_v(double y, double v) const {
    assert(!stratonovich_factor_);
    return formula_ ? sign_ * formula_->with_slope_in_v(y, v).derivative
                    : damping_(y) + 3 * c_.rayleigh * v * v;
  }
  /// Returns the formula of the force. @pre !has_polynomial_force()
  const Expression& force_formula() const {
    assert(formula_);
    return formula_->formula();
  }
  bool has_force_jumps() const { return formula_ && formula_->formula().has_jumps(); }
  /// Returns whether the force jumps in v, as dry friction mu_c sign(v) does at v = 0.
  bool has_force_jumps_in_v() const { return formula_ && formula_->formula().has_jumps_in_v(); }
  /// Returns whether the force jumps in v at a velocity 0 < |v| < `v_limit`.
  bool has_force_jumps_at_nonzero_v(double v_limit) const {
    return formula_ && formula_->formula().has_jumps_at_nonzero_v(v_limit);
  }
  /// Returns the values of y in (low, high) at which the force or its slope jumps, in increasing
  /// order.
  std::vector<double> kinks_in_y(double low, double high) const;
  /// Returns the values of v in (low, high) at which the force or its slope jumps, in increasing
  /// order.
  std::vector<double> kinks_in_v(double low, double high) const;

  // The damping polynomials of a System are defined only if has_polynomial_force().

  /// Returns the linear damping coefficient c(0) of the damping polynomial c(y).
  double damping() const {
    assert(has_polynomial_force());
    return damping_.coefficient(0);
  }
  const numerics::Polynomial& damping_polynomial() const {
    assert(has_polynomial_force());
    return damping_;
  }
  double rayleigh_coefficient() const {
    assert(has_polynomial_force());
    return c_.rayleigh;
  }
  bool has_constant_damping() const {
    return !formula_ && damping_.degree() == 0 && c_.rayleigh == 0;
  }

  const Walls& walls() const { return walls_; }
  const std::optional<Wall>& left_wall() const { return walls_.left; }
  const std::optional<Wall>& right_wall() const { return walls_.right; }
  /// Returns the restitution coefficient of the left wall, or 1 without a left wall.
  double restitution() const { return walls_.left ? walls_.left->restitution : 1; }

  /// Returns whether the restitution coefficients of all walls are independent of the impact speed.
  bool has_constant_restitution() const {
    return (!walls_.left || walls_.left->has_constant_restitution()) &&
           (!walls_.right || walls_.right->has_constant_restitution());
  }

  const numerics::Polynomial& restoring_force() const {
    assert(has_polynomial_force());
    return force_;
  }
  const numerics::Polynomial& tangent_stiffness() const {
    assert(has_polynomial_force());
    return tangent_;
  }
  /// Returns the potential U(y), the integral of the restoring force g from 0 to y.
  const numerics::Polynomial& potential() const {
    assert(has_polynomial_force());
    return potential_;
  }
  bool has_linear_force() const {
    return !formula_ && force_.degree() <= 1 && force_.coefficient(0) == 0;
  }
  /// Returns the stiffness k = g'(0), the slope of the restoring force g at y = 0.
  double stiffness() const { return tangent_.coefficient(0); }

  /// Returns the oscillator in wall coordinates x, where y = origin + sign x. In wall coordinates x
  /// the restoring force is sign g(origin + sign x), and the damping polynomial is c(origin + sign
  /// x). A mirrored frame exchanges the left and the right wall.
  System to_wall_coordinates(const WallFrame& frame) const;

 private:
  SystemCoefficients c_;
  WallParameters wall_parameters_;
  NamedConstants constants_;
  Walls walls_;
  numerics::Polynomial force_{{}}, tangent_{{}}, potential_{{}}, damping_{{}}, damping_slope_{{}};
  std::optional<StateFunction> formula_;  // force of a formula that is not a polynomial
  double sign_ = 1;                       // sign of velocities and forces in wall coordinates
  // Factor of multiplicative noise in Stratonovich's sense. The member function force() subtracts
  // the drift D G_v / 2, where G is the square of the noise factor.
  std::optional<NoiseFactor> stratonovich_factor_;
  double stratonovich_diffusion_ = 0;
};

}  // namespace fpkcheck::problem
