#pragma once

#include <optional>

#include "base/options/description.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/frame.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::problem {

/// Coefficients of the oscillator, as read from a case file. All quantities are non-dimensional,
/// here and in the whole project.
struct SystemCoefficients {
  double damping = 0;      ///< c, of y'
  double van_der_pol = 0;  ///< of y^2 y'
  double rayleigh = 0;     ///< of y'^3
  double constant = 0;     ///< restoring force at y = 0
  double stiffness = 0;    ///< k, of y
  double quadratic = 0;    ///< of y^2
  double cubic = 0;        ///< mu, of y^3
  double quintic = 0;      ///< of y^5
  /// r, 0 < r <= 1, of a wall at y = 0 on the left; absent where [wall] defines the walls.
  std::optional<double> restitution = {};
};

/// The description of the coefficients.
const base::Description<SystemCoefficients>& system_description();

/// The oscillator, paper (1)-(2) and its generalisation:
///
///     y'' + f(y, y') + g(y) = xi(t)  between the walls,    y'(+) = -r y'(-)  at each wall,
///     f = y' (c(y) + c_vv y'^2),   c(y) = c + c_yy y^2,
///     g = g_0 + k y + k_2 y^2 + mu y^3 + k_5 y^5.
///
/// The paper has g = k y + mu y^3 and f = c y' at y > 0. Force and damping are defined here only;
/// all other code uses these polynomials for the force, its slope and its potential. (On the
/// (z, z') plane of paper (5) the force at z < 0 is -g(-z).)
class System {
 public:
  /// @throws InputError naming the coefficient, its value and the allowed range
  explicit System(const SystemCoefficients& coefficients, const WallParameters& walls = {});

  /// The coefficients of the case file, independent of the frame.
  const SystemCoefficients& coefficients() const { return c_; }
  const WallParameters& wall_parameters() const { return wall_parameters_; }

  /// c(0); the damping coefficient where damping_is_constant().
  double damping() const { return damping_.coefficient(0); }
  /// c(y).
  const numerics::Polynomial& damping_polynomial() const { return damping_; }
  /// c_vv, the coefficient of y'^3.
  double rayleigh() const { return c_.rayleigh; }
  /// Whether f = c y'.
  bool damping_is_constant() const { return damping_.degree() == 0 && c_.rayleigh == 0; }

  const Walls& walls() const { return walls_; }
  const std::optional<Wall>& left() const { return walls_.left; }
  const std::optional<Wall>& right() const { return walls_.right; }
  /// Coefficient of restitution of the left wall; 1 without a left wall.
  double restitution() const { return walls_.left ? walls_.left->restitution : 1; }

  /// g(y), the restoring force.
  const numerics::Polynomial& force() const { return force_; }
  /// g'(y), the tangent stiffness.
  const numerics::Polynomial& tangent_stiffness() const { return tangent_; }
  /// U(y), the integral of g from 0.
  const numerics::Polynomial& potential() const { return potential_; }
  /// Whether g(y) = k y.
  bool linear() const { return force_.degree() <= 1 && force_.coefficient(0) == 0; }
  /// k = g'(0), the stiffness at the wall.
  double stiffness() const { return tangent_.coefficient(0); }

  /// The same oscillator in wall coordinates x, y = origin + sign x: the force on x is
  /// sign g(origin + sign x), the damping c(origin + sign x). Mirroring exchanges left and right
  /// walls.
  System to_wall_coordinates(const Frame& frame) const;

 private:
  SystemCoefficients c_;
  WallParameters wall_parameters_;
  Walls walls_;
  numerics::Polynomial force_, tangent_, potential_, damping_;
};

}  // namespace fpkcheck::problem
