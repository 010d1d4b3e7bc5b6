#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "backward/generator/generator_enclosures.hpp"
#include "backward/generator/impact_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Values of the three factors in v of the generator L at collocation points, rounded to nearest.
/// The least-squares fit of the backward equation needs no guaranteed enclosures of the generator.
/// Each matrix of values has the shape (collocation points, splines).
struct GeneratorVelocityFactorSamples {
  std::vector<double> velocities;               ///< collocation points, increasing
  Eigen::MatrixXd impulse_and_damping;          ///< values of lambda (K B_b - B_b) - c v B_b'
  Eigen::SparseMatrix<double> transport;        ///< values of v B_b
  Eigen::SparseMatrix<double> restoring_force;  ///< values of -B_b'
};

/// Values and slopes of the splines A_a(y) at the collocation points of the least-squares fit.
struct DisplacementSplineSamples {
  std::vector<double> displacements;  ///< collocation points, increasing
  std::vector<int> knot_spans;        ///< index of the knot span that contains each point
  /// Values (row 0) and slopes (row 1) of the degree + 1 splines that are nonzero on a knot span,
  /// one matrix of shape (2, degree + 1) for each collocation point
  std::vector<Eigen::MatrixXd> values_and_slopes;
};

/// Evaluates the splines of y at `points_per_cell` Chebyshev points of every cell of y.
DisplacementSplineSamples sample_displacement_splines(const numerics::SplineBasis& basis,
                                                      int points_per_cell);

/// Evaluates the factors in v of the generator at `points_per_cell` Chebyshev points of every cell
/// of v, from the midpoints of the enclosed Bernstein coefficients.
GeneratorVelocityFactorSamples sample_velocity_factors(
    const GeneratorVelocityFactorEnclosures& enclosures, const ImpactSplineBasis& basis,
    int points_per_cell);

}  // namespace fpkcheck::backward
