#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "backward/generator/generator_enclosures.hpp"
#include "backward/generator/impact_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Values of the three factors in v of the generator (VelocityFactorEnclosures), rounded to
/// nearest. The least-squares fit needs no guaranteed enclosures.
struct VelocityFactorSamples {
  std::vector<double> v;  ///< collocation points, increasing
  Eigen::MatrixXd jump;   ///< factor lambda (K B - B) - c v B', shape (points, functions)
  Eigen::SparseMatrix<double> drift;  ///< factor v B of the generator
  Eigen::SparseMatrix<double> force;  ///< factor -B' of the generator
};

struct DisplacementSplineSamples {
  std::vector<double> y;
  std::vector<int> span;
  std::vector<Eigen::MatrixXd> values;  ///< values and slopes of the splines, shape (2, degree + 1)
};

DisplacementSplineSamples sample_displacement_splines(const numerics::SplineBasis& basis,
                                                      int points_per_cell);

/// Returns the velocity factors of the generator at `points_per_cell` Chebyshev points of every
/// cell of v.
VelocityFactorSamples sample_velocity_factors(const VelocityFactorEnclosures& operators,
                                              const ImpactBasis& basis, int points_per_cell);

}  // namespace fpkcheck::backward
