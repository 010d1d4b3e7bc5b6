#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "transform/density.hpp"

namespace fpkcheck::backward {

using RowMajorSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Returns the matrix that maps cell averages to values at points, shape (points, n). The values
/// are the slope of the cumulative distribution, which polynomials of degree 7 interpolate between
/// the edges (as in transform::ConservativeRemap). Each cell therefore keeps its mass, and the
/// values of a smooth function have an error of seventh order in the cell width. No stencil crosses
/// an edge at 0. A point on an edge belongs to the cell above the edge. A point on the last edge
/// belongs to the last cell. Values beyond the first and the last edge are 0.
/// @param edges n + 1 increasing cell edges
RowMajorSparseMatrix reconstruction_matrix(std::span<const double> edges,
                                           std::span<const double> points);

/// Quadrature rule along an axis for a density given by samples. The samples are values at the
/// points, or averages over cells.
struct AxisQuadrature {
  std::vector<double> points;
  /// Matrix of shape (points, samples) that maps samples to quadrature weight times density at the
  /// points
  RowMajorSparseMatrix weighted;

  /// Returns the integrals of each function times the density, as linear forms of the samples,
  /// shape (functions, samples).
  /// @param functions values at the points, shape (points, functions)
  Eigen::MatrixXd integrals_with_density(const Eigen::MatrixXd& functions) const {
    return functions.transpose() * weighted;
  }
  /// Returns integrals_with_density() as a sparse matrix, for functions with a small support, such as
  /// splines.
  RowMajorSparseMatrix sparse_integrals_with_density(const Eigen::MatrixXd& functions) const {
    return RowMajorSparseMatrix(functions.transpose().sparseView()) * weighted;
  }
};

/// Density at a wall as a function of the impact speed.
struct SampledWallDensity {
  AxisQuadrature speeds;
  Eigen::VectorXd samples;
};

/// Density p in discretised form. The integral of a(y) b(v) p is a row vector times the matrix of
/// samples times a column vector.
struct SampledDensity {
  AxisQuadrature y, v;
  Eigen::MatrixXd samples;  ///< samples of the density, shape (samples along y, samples along v)
  std::vector<SampledWallDensity> impacts;
};

/// Impact speeds at which integrands over impacts at a wall are not smooth.
struct ImpactBreaks {
  double position;
  double rebound_sign;         ///< ImpactWall::rebound_sign: 1 at a left wall, -1 at a right wall
  std::vector<double> speeds;  ///< impact speeds, increasing from 0
};

/// Increasing points at which integrands are not smooth, and at which the panels of the quadrature
/// rules end.
struct IntegrandBreaks {
  std::span<const double> y, v;
  std::span<const ImpactBreaks> walls;
};

/// Samples a density at the points of a Gauss rule of six points between all breaks of the density
/// and of the integrands. The rule is exact for the product of a spline of degree 5 and a
/// polynomial of reconstruction_matrix(). For a density given as a function no panel is longer than
/// 1/24 of the range. A density has no impacts at a wall that is outside the range of the density.
/// @throws InputError when the edges do not increase, extend past a wall, do not begin at a left
/// wall or do not match the number of averages
/// @throws InputError when a density given as a function has no range of positive length
SampledDensity sample_density(const transform::Density& density, const IntegrandBreaks& breaks);

}  // namespace fpkcheck::backward
