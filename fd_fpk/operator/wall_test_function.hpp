#pragma once

#include <numbers>

namespace fpkcheck::fd_fpk {

/// A function h(y, v), y > 0 the distance from a wall and v the velocity away from it, whose mean is
/// raised by the same amount at every impact there, whatever its speed: h = f + f_1,
///
///     D f_vv + v f_y = 0,              f = log(y) / 3 + phi(s),             s = v / (D y)^(1/3),
///     D f_1,vv + v f_1,y = F_0 f_v,    f_1 = (F_0 / D) (D y)^(1/3) chi(s),  F_0 the force at the wall,
///
/// with phi and chi without a part that grows as e^(s^3/9). By substitution
///
///     phi'' = s (s phi' - 1) / 3,   theta = chi - s chi',   theta' = s (s theta / 3 - phi'),
///     chi'' = phi' - s theta / 3.
///
/// At the wall f is log|v| and a constant on either side: f(0, u) - f(0, -u) = pi / sqrt 3, the
/// integral of phi' over all s. f_1 is proportional to |v| there; the share of v in it, which solves
/// the equation without a source, makes f_1(0, r u) = f_1(0, -u). So an impact raises h by
/// pi / sqrt 3 + log r: 0 where impacts accumulate (problem::kCollapseRestitution).
///
/// What remains of the backward equation of noise D and force F is F h_v - F_0 f_v, bounded at the
/// wall where F h_v alone goes as 1/v.
class WallTestFunction {
 public:
  /// @param diffusion D > 0
  /// @param force F_0, towards the wall
  /// @param restitution r > 0
  WallTestFunction(double diffusion, double force, double restitution);

  /// @pre y > 0
  double operator()(double y, double v) const;
  /// F h_v - F_0 f_v at a point with the force F.
  double remainder(double y, double v, double force) const;
  /// h_v.
  double slope(double y, double v) const;

  /// f(0, u) - f(0, -u).
  static constexpr double kStepAtWall = std::numbers::pi / std::numbers::sqrt3;

 private:
  double length(double y) const;

  double diffusion_, force_;
  double share_of_v_;  // of f_1, in units of F_0 / D
};

}  // namespace fpkcheck::fd_fpk
