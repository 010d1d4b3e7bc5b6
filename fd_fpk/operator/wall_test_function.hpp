#pragma once

#include <numbers>

namespace fpkcheck::fd_fpk {

/// Test function h(y, v) of the distance y > 0 from a wall and the velocity v away from the wall.
/// Every impact increases h = f + f_1 by an amount that does not depend on the impact speed:
///
///     D f_vv + v f_y = 0,              f = log(y) / 3 + phi(s),             s = v / (D y)^(1/3),
///     D f_1,vv + v f_1,y = F_0 f_v,    f_1 = (F_0 / D) (D y)^(1/3) chi(s), F_0 the force at y = 0,
///
/// The functions phi(s) and chi(s) of the similarity variable s, which define the terms f and f_1
/// of the test function, have no component that grows as e^(s^3/9). Substitution into the backward
/// equation gives ordinary differential equations for phi and chi:
///
///     phi'' = s (s phi' - 1) / 3,   theta = chi - s chi',   theta' = s (s theta / 3 - phi'),
///     chi'' = phi' - s theta / 3.
///
/// At the wall the leading term f of the test function is log|v| plus a constant that depends on
/// the sign of the velocity v. The difference f(0, u) - f(0, -u) of the leading term at the wall is
/// pi / sqrt 3, the integral of phi'(s) over all s. At the wall the second term f_1 is proportional
/// to |v|, plus a multiple of v (a homogeneous solution) such that f_1(0, r u) = f_1(0, -u) for the
/// restitution coefficient r. An impact therefore increases the test function h by pi / sqrt 3 +
/// log r. The increase of h in an impact is 0 at the restitution coefficient below which impacts
/// accumulate (problem::kCollapseRestitution).
///
/// For a force F that varies from its value F_0 at the wall, the test function h satisfies the
/// backward equation up to the remainder F h_v - F_0 f_v, which is bounded at the wall.
class WallTestFunction {
 public:
  /// @param diffusion noise coefficient D > 0
  /// @param force force F_0 at the wall, positive if directed towards the wall
  /// @param restitution restitution coefficient r > 0
  WallTestFunction(double diffusion, double force, double restitution);

  /// @pre y > 0
  double operator()(double y, double v) const;
  /// Returns the remainder F h_v - F_0 f_v of the backward equation, for the force F at the
  /// distance y from the wall and the velocity v.
  double backward_equation_remainder(double y, double v, double force) const;
  double velocity_derivative(double y, double v) const;

  /// Difference f(0, u) - f(0, -u) of the leading term f of the test function at the wall, equal
  /// for all speeds u
  static constexpr double kStepAtWall = std::numbers::pi / std::numbers::sqrt3;

 private:
  double velocity_scale(double y) const;

  double diffusion_, force_;
  double v_coefficient_;  // coefficient of v in f_1, in units of F_0 / D
};

}  // namespace fpkcheck::fd_fpk
