#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "dual/spline/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::dual {

/// Functions and their slopes at points, shape (points, functions).
struct SplineValues {
  Eigen::MatrixXd value, slope;
};
SplineValues values_at(const KnotSplines& splines, std::span<const double> points);

/// By how much functions jump at impacts, B_j(r u) - B_j(-u), shape (speeds u, functions).
Eigen::MatrixXd jumps_at(const KnotSplines& splines, double restitution,
                         std::span<const double> speeds);

inline constexpr int kGeneratorTerms = 3;
/// One variable's factors of the terms of
///
///     L (A B) = A' v B + A (lambda (K B - B) - c v B') - g A B'
///
/// at points, each of shape (points, functions).
using GeneratorFactors = std::array<Eigen::MatrixXd, kGeneratorTerms>;

/// A', A, g A
GeneratorFactors factors_of_y(const problem::System& system, const KnotSplines& splines,
                              std::span<const double> points);
/// v B, lambda (K B - B) - c v B', -B'
/// @param means K B at the points (impulse_means)
GeneratorFactors factors_of_v(const problem::Problem& problem, const KnotSplines& splines,
                              std::span<const double> points, const Eigen::MatrixXd& means);

}  // namespace fpkcheck::dual
