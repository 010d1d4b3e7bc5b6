#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/excitation.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Values B_j(x_n) and slopes B_j'(x_n) of splines B_j at points x_n, shape (points, splines).
struct SplineValuesAtPoints {
  Eigen::MatrixXd values, slopes;
};

/// Returns the values and slopes of all splines at given points.
SplineValuesAtPoints evaluate_splines(const numerics::QuinticBSplines& splines,
                                      std::span<const double> points);

/// A wall with its impact condition. In an impact of speed u the velocity is -rebound_sign u before
/// the impact and rebound_sign r u after the impact, with the restitution coefficient r.
struct WallWithRestitution {
  double position;
  double restitution;
  /// Sign of the velocity after an impact: 1 at a left wall, -1 at a right wall
  double rebound_sign;
};

/// Returns the walls of an oscillator with their restitution coefficients, the left wall first.
std::vector<WallWithRestitution> walls_with_restitution(const problem::System& system);

/// Returns the jumps of the splines at impacts of speed u, B_j(s r u) - B_j(-s u) with s =
/// rebound_sign, in a matrix of shape (speeds u, splines).
Eigen::MatrixXd spline_jumps_at_impacts(const numerics::QuinticBSplines& splines,
                                        const WallWithRestitution& wall,
                                        std::span<const double> speeds);

/// Returns the impact speeds u, in increasing order from u = 0, at which spline_jumps_at_impacts()
/// is not smooth in u. At the returned impact speeds the velocity before or after the impact is a
/// break of the splines.
std::vector<double> impact_speed_breaks(const numerics::QuinticBSplines& splines,
                                        const WallWithRestitution& wall);

/// Factors in y and in v of the generator L, applied to a product of splines A(y) B(v):
///
///     L (A B) = A' v B + A (lambda (K B - B) - (c + c_vv v^2) v B' + D B'') - g A B'
///               - (c(y) - c) A v B',      c = c(0).
///
/// Each term of the generator L is a factor in y times a factor in v. The list contains either all
/// factors in y or all factors in v of the generator L. Each factor of the generator is stored as a
/// matrix of values at points, of shape (points, splines). If the damping does not depend on
/// position, c(y) = c, the last term of the generator L is absent.
using GeneratorFactors = std::vector<Eigen::MatrixXd>;

/// Returns the factors in y at the points: A', A, g A, (c(y) - c) A.
GeneratorFactors displacement_generator_factors(const problem::System& system,
                                                const numerics::QuinticBSplines& splines,
                                                std::span<const double> points);

/// Returns the factors in v of the generator at given points: v B, lambda (K B - B) - (c + c_vv
/// v^2) v B' + D B'', -B', -v B'.
/// @param means_after_impulse values of K B at the points; not used without impulses
GeneratorFactors velocity_generator_factors(const problem::Problem& problem,
                                            const numerics::QuinticBSplines& splines,
                                            std::span<const double> points,
                                            const Eigen::MatrixXd& means_after_impulse);

/// Returns the means (K B_j)(v) = E[B_j(v + Y)] of the splines B_j after an impulse Y, at the
/// velocities v, in a matrix of shape (velocities, splines). The smooth pieces of the density of an
/// impulse Y are divided at the breaks of the splines, and into parts no longer than the standard
/// deviation of Y. A Gauss rule of 8 points integrates a spline over each part of the density of an
/// impulse with an error of 1e-15. Atoms of the law are summed exactly.
Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseLaw& law,
                                           std::span<const double> v);

/// Returns the means (K B_j)(v) = E[B_j(v + Y)] of splines for the amplitude law of an impulse
/// train; shape (0, 0) without impulses.
Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseTrain& impulses,
                                           std::span<const double> v);

}  // namespace fpkcheck::backward
