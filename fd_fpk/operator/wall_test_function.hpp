#pragma once

#include <numbers>

namespace fpkcheck::fd_fpk {

/// A test function h(y, v), with the distance y > 0 from a wall and the velocity v away from the
/// wall. Every impact increases h by the same amount, whatever the impact speed: h = f + f_1,
///
///     D f_vv + v f_y = 0,              f = log(y) / 3 + phi(s),             s = v / (D y)^(1/3),
///     D f_1,vv + v f_1,y = F_0 f_v,    f_1 = (F_0 / D) (D y)^(1/3) chi(s), F_0 the force at y = 0,
///
/// with phi and chi without a component that grows as e^(s^3/9). By substitution
///
///     phi'' = s (s phi' - 1) / 3,   theta = chi - s chi',   theta' = s (s theta / 3 - phi'),
///     chi'' = phi' - s theta / 3.
///
/// At the wall f is log|v| plus a constant for each sign of v: f(0, u) - f(0, -u) = pi / sqrt 3,
/// the integral of phi' over all s. At the wall f_1 is proportional to |v|. A multiple of v, which
/// solves the homogeneous equation, is added to f_1 such that f_1(0, r u) = f_1(0, -u). An impact
/// therefore increases h by pi / sqrt 3 + log r. This amount is 0 at the restitution coefficient
/// below which impacts accumulate (problem::kCollapseRestitution).
///
/// Inserted into the backward equation with noise D and force F, h leaves the remainder F h_v - F_0
/// f_v. The remainder is bounded at the wall, whereas F h_v alone is proportional to 1/v.
class WallTestFunction {
 public:
  /// @param diffusion D > 0
  /// @param force F_0, towards the wall
  /// @param restitution r > 0
  WallTestFunction(double diffusion, double force, double restitution);

  /// @pre y > 0
  double operator()(double y, double v) const;
  /// The remainder F h_v - F_0 f_v of the backward equation, at a point with the force F.
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
