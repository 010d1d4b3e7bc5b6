#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/excitation.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Values and slopes of splines at points, each of shape (points, functions).
struct SplineValues {
  Eigen::MatrixXd value, slope;
};
SplineValues spline_values(const numerics::QuinticBSplines& splines,
                           std::span<const double> points);

/// A wall with its impact condition. An impact of speed u has the velocity -rebound_sign u before
/// the impact and rebound_sign r u after the impact.
struct ImpactWall {
  double position;
  double restitution;
  /// Sign of the velocity after an impact: 1 at a left wall, -1 at a right wall
  double rebound_sign;
};
std::vector<ImpactWall> impact_walls(const problem::System& system);

/// Returns the jumps of the splines at impacts, B_j(s r u) - B_j(-s u) with s = rebound_sign, shape
/// (speeds u, functions).
Eigen::MatrixXd spline_jumps_at_impacts(const numerics::QuinticBSplines& splines,
                                        const ImpactWall& wall, std::span<const double> speeds);
/// Returns the impact speeds u at which spline_jumps_at_impacts() is not smooth, increasing from 0,
/// within the range of the splines.
std::vector<double> non_smooth_impact_speeds(const numerics::QuinticBSplines& splines,
                                             const ImpactWall& wall);

/// Factors in y, or factors in v, of the terms of the generator
///
///     L (A B) = A' v B + A (lambda (K B - B) - (c + c_vv v^2) v B' + D B'') - g A B'
///               - (c(y) - c) A v B',      c = c(0),
///
/// Each factor is a matrix of values at points, of shape (points, functions). Without
/// position-dependent damping, c(y) = c, the last term of L is absent.
using GeneratorFactors = std::vector<Eigen::MatrixXd>;

/// Returns the factors in y: A', A, g A, (c(y) - c) A.
GeneratorFactors displacement_generator_factors(const problem::System& system,
                                                const numerics::QuinticBSplines& splines,
                                                std::span<const double> points);
/// Returns the factors in v: v B, lambda (K B - B) - (c + c_vv v^2) v B' + D B'', -B', -v B'.
/// @param means K B at the points (spline_means_after_impulse); ignored without impulses
GeneratorFactors velocity_generator_factors(const problem::Problem& problem,
                                            const numerics::QuinticBSplines& splines,
                                            std::span<const double> points,
                                            const Eigen::MatrixXd& means);

/// Returns the means (K B_j)(v) = E[B_j(v + Y)] of the splines after an impulse, at the velocities
/// v, shape (points, functions). The smooth pieces of the density of Y are divided at the breaks of
/// the splines, and into parts no longer than the standard deviation of Y. The Gauss rule of 8
/// points integrates each part with an error of 1e-15. Atoms of the law are summed exactly.
Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseLaw& law,
                                           std::span<const double> v);
/// Returns the means (K B_j)(v) for the amplitude law of an impulse train; shape (0, 0) without
/// impulses.
Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseTrain& impulses,
                                           std::span<const double> v);

}  // namespace fpkcheck::backward
