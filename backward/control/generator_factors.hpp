#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Functions and their slopes at points, shape (points, functions).
struct SplineValues {
  Eigen::MatrixXd value, slope;
};
SplineValues values_at(const numerics::KnotSplines& splines, std::span<const double> points);

/// A wall as the generator sees it: impacts of speed u come with -away u and leave with away r u.
struct ImpactWall {
  double position;
  double restitution;
  double away;  ///< 1 at the left end of the motion, -1 at the right one
};
/// From left to right.
std::vector<ImpactWall> impact_walls(const problem::System& system);

/// By how much functions jump at impacts, B_j(away r u) - B_j(-away u), shape (speeds u, functions).
Eigen::MatrixXd jumps_at(const numerics::KnotSplines& splines, const ImpactWall& wall,
                         std::span<const double> speeds);
/// Where that is less smooth in u: increasing from 0, as far as the splines reach.
std::vector<double> breaks_of_jumps(const numerics::KnotSplines& splines, const ImpactWall& wall);

/// One variable's factors of the terms of
///
///     L (A B) = A' v B + A (lambda (K B - B) - (c + c_vv v^2) v B' + D B'') - g A B'
///               - (c(y) - c) A v B',      c = c(0),
///
/// at points, each of shape (points, functions). The last term is absent where c(y) = c.
using GeneratorFactors = std::vector<Eigen::MatrixXd>;

/// A', A, g A, (c(y) - c) A
GeneratorFactors factors_of_y(const problem::System& system, const numerics::KnotSplines& splines,
                              std::span<const double> points);
/// v B, lambda (K B - B) - (c + c_vv v^2) v B' + D B'', -B', -v B'
/// @param means K B at the points (impulse_means); of any shape where there are no impulses
GeneratorFactors factors_of_v(const problem::Problem& problem, const numerics::KnotSplines& splines,
                              std::span<const double> points, const Eigen::MatrixXd& means);

}  // namespace fpkcheck::backward
