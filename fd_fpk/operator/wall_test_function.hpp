#pragma once

#include <numbers>

namespace fpkcheck::fd_fpk {

/// A test function h(y, v), with the distance y > 0 from a wall and the velocity v away from the
/// wall. Every impact increases h by an amount that does not depend on the impact speed: h = f +
/// f_1,
///
///     D f_vv + v f_y = 0,              f = log(y) / 3 + phi(s),             s = v / (D y)^(1/3),
///     D f_1,vv + v f_1,y = F_0 f_v,    f_1 = (F_0 / D) (D y)^(1/3) chi(s), F_0 the force at y = 0,
///
/// where the functions phi and chi have no component that grows as e^(s^3/9). By substitution
///
///     phi'' = s (s phi' - 1) / 3,   theta = chi - s chi',   theta' = s (s theta / 3 - phi'),
///     chi'' = phi' - s theta / 3.
///
/// At the wall f is log|v| plus a constant, which depends on the sign of v: f(0, u) - f(0, -u) = pi
/// / sqrt 3, the integral of phi' over all s. At the wall f_1 is proportional to |v|. f_1 includes
/// a multiple of v, a solution of the homogeneous equation, such that f_1(0, r u) = f_1(0, -u). An
/// impact therefore increases h by pi / sqrt 3 + log r. The increase pi / sqrt 3 + log r is 0 at
/// the restitution coefficient below which impacts accumulate (problem::kCollapseRestitution).
///
/// In the backward equation with noise D and force F, the test function h leaves the remainder F
/// h_v - F_0 f_v. This remainder is bounded at the wall, whereas F h_v alone is proportional to
/// 1/v.
class WallTestFunction {
 public:
  /// @param diffusion D > 0
  /// @param force F_0, towards the wall
  /// @param restitution r > 0
  WallTestFunction(double diffusion, double force, double restitution);

  /// @pre y > 0
  double operator()(double y, double v) const;
  /// The remainder F h_v - F_0 f_v of the backward equation, at a point (y, v) where the force is
  /// F.
  double backward_remainder(double y, double v, double force) const;
  /// The derivative h_v of the test function with respect to the velocity.
  double velocity_derivative(double y, double v) const;

  /// The difference f(0, u) - f(0, -u) at the wall, the same for every speed u.
  static constexpr double kStepAtWall = std::numbers::pi / std::numbers::sqrt3;

 private:
  double velocity_scale(double y) const;

  double diffusion_, force_;
  double v_coefficient_;  // coefficient of v in f_1, in units of F_0 / D
};

}  // namespace fpkcheck::fd_fpk
