#pragma once

#include <optional>

#include "base/options/description.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::problem {

/// Coefficients of the oscillator, as read from the section [system] of a case file. All quantities
/// of the program are non-dimensional.
struct SystemCoefficients {
  double damping = 0;      ///< linear damping c, coefficient of y'
  double van_der_pol = 0;  ///< damping coefficient of y^2 y'
  double rayleigh = 0;     ///< damping coefficient of y'^3
  double constant = 0;     ///< restoring force at y = 0
  double stiffness = 0;    ///< linear stiffness k, coefficient of y
  double quadratic = 0;    ///< stiffness coefficient of y^2
  double cubic = 0;        ///< cubic stiffness mu, coefficient of y^3
  double quintic = 0;      ///< stiffness coefficient of y^5
  /// Restitution coefficient r, 0 < r <= 1, of a wall at y = 0 on the left; absent if the section
  /// [wall] defines the walls.
  std::optional<double> restitution = {};
};

const base::Description<SystemCoefficients>& system_parameter_description();

/// The oscillator of paper (1)-(2), generalised to any polynomial force of degree 5 and to two
/// walls:
///
///     y'' + f(y, y') + g(y) = xi(t)  between the walls,    y'(+) = -r y'(-)  at each wall,
///     f = y' (c(y) + c_vv y'^2),   c(y) = c + c_yy y^2,
///     g = g_0 + k y + k_2 y^2 + mu y^3 + k_5 y^5.
///
/// The oscillator of the paper has the restoring force g = k y + mu y^3, the damping force f = c y'
/// and the motion in y > 0. On the (z, z') plane of paper (5), the restoring force at z < 0 is
/// -g(-z).
class System {
 public:
  /// @throws InputError that states the invalid coefficient, its value and the allowed range
  explicit System(const SystemCoefficients& coefficients, const WallParameters& walls = {});

  /// Returns the coefficients of the case file in physical coordinates, even for a system in wall
  /// coordinates.
  const SystemCoefficients& coefficients() const { return c_; }
  const WallParameters& wall_parameters() const { return wall_parameters_; }

  /// Returns the damping coefficient c(0), which is the only damping coefficient for constant
  /// damping.
  double damping() const { return damping_.coefficient(0); }
  const numerics::Polynomial& damping_polynomial() const { return damping_; }
  double rayleigh_coefficient() const { return c_.rayleigh; }
  bool has_constant_damping() const { return damping_.degree() == 0 && c_.rayleigh == 0; }

  const Walls& walls() const { return walls_; }
  const std::optional<Wall>& left_wall() const { return walls_.left; }
  const std::optional<Wall>& right_wall() const { return walls_.right; }
  /// Returns the restitution coefficient of the left wall, or 1 without a left wall.
  double restitution() const { return walls_.left ? walls_.left->restitution : 1; }

  const numerics::Polynomial& restoring_force() const { return force_; }
  const numerics::Polynomial& tangent_stiffness() const { return tangent_; }
  /// Returns the potential U(y), the integral of g from 0 to y.
  const numerics::Polynomial& potential() const { return potential_; }
  bool has_linear_force() const { return force_.degree() <= 1 && force_.coefficient(0) == 0; }
  /// Returns the stiffness k = g'(0).
  double stiffness() const { return tangent_.coefficient(0); }

  /// Returns this oscillator in wall coordinates x, where y = origin + sign x. The restoring force
  /// in wall coordinates is sign g(origin + sign x), and the damping polynomial is c(origin + sign
  /// x). A mirrored frame exchanges the left and the right wall.
  System to_wall_coordinates(const WallFrame& frame) const;

 private:
  SystemCoefficients c_;
  WallParameters wall_parameters_;
  Walls walls_;
  numerics::Polynomial force_, tangent_, potential_, damping_;
};

}  // namespace fpkcheck::problem
