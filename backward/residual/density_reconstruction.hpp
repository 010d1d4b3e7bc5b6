#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "transform/joint_density.hpp"

namespace fpkcheck::backward {

using RowMajorSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Returns the matrix that maps n cell averages of a density to values of the density at points, of
/// shape (points, n). The values of the density are slopes of the cumulative distribution, which
/// polynomials of degree 7 interpolate between the cell edges (as in transform::ConservativeRemap).
/// The polynomials conserve the probability of each cell, and the values of a smooth density have
/// an error of seventh order in the cell width. No stencil crosses an edge at 0. A point on an edge
/// between two cells belongs to the cell above the edge. A point on the last edge of the cells
/// belongs to the last cell. The density beyond the first and the last cell edge is 0.
/// @param edges n + 1 increasing cell edges
RowMajorSparseMatrix density_reconstruction_matrix(std::span<const double> edges,
                                                   std::span<const double> points);

/// Quadrature rule along one axis for a density that is given by samples (values or cell averages).
/// The samples of a density are its values at the quadrature points, or its averages over cells.
struct DensityAxisQuadrature {
  std::vector<double> points;
  /// Matrix of shape (points, samples) that maps the samples of a density to the products of
  /// quadrature weight and density at the quadrature points
  RowMajorSparseMatrix weighted_density_matrix;

  /// Returns the integrals of each function times the density, as linear forms of the samples of
  /// the density, shape (functions, samples).
  /// @param function_values function values at quadrature points, shape (points, functions)
  Eigen::MatrixXd integrals_of_functions_times_density(
      const Eigen::MatrixXd& function_values) const {
    return function_values.transpose() * weighted_density_matrix;
  }
  /// Returns the result of integrals_of_functions_times_density() as a sparse matrix, for functions
  /// with a small support, such as splines.
  RowMajorSparseMatrix sparse_integrals_times_density(
      const Eigen::MatrixXd& function_values) const {
    return RowMajorSparseMatrix(function_values.transpose().sparseView()) * weighted_density_matrix;
  }
};

/// Density p(wall, v) before an impact at a wall, as a function of the impact speed |v|.
struct SampledWallDensity {
  DensityAxisQuadrature speed_quadrature;
  Eigen::VectorXd samples;  ///< samples of the density along the axis of the impact speed
};

/// Density p(y, v) given by samples. With the linear forms a for a function of y and b for a
/// function of v (integrals_of_functions_times_density()), the integral of the product of both
/// functions and the density is a^T samples b.
struct SampledDensity {
  DensityAxisQuadrature y_quadrature, v_quadrature;
  Eigen::MatrixXd samples;  ///< samples of the density, shape (samples along y, samples along v)
  std::vector<SampledWallDensity> wall_densities;  ///< density at each wall of IntegrandBreakpoints
};

/// Impact speeds at which the integrands of integrals over the impacts at a wall are not smooth.
struct ImpactSpeedBreakpoints {
  double wall_position;
  /// Sign of the velocity after an impact (see WallWithRestitution): 1 at a left wall, -1 at a
  /// right wall
  double rebound_sign;
  std::vector<double> breaks;  ///< impact speeds, increasing from 0
};

/// Increasing points at which integrands are not smooth, where quadrature panels end.
struct IntegrandBreakpoints {
  std::span<const double> y_breaks, v_breaks;
  std::span<const ImpactSpeedBreakpoints> impact_breaks;  ///< one element for each wall
};

/// Samples a density at the points of Gauss rules of six points on the intervals between successive
/// breaks of the density and of the integrands. The Gauss rule with six points is exact for the
/// product of a spline of degree 5 and a polynomial of density_reconstruction_matrix(). For a
/// density given as a function no panel of the quadrature is longer than 1/24 of the range. The
/// density at a wall that is outside the range of the density is 0.
/// @throws InputError when the edges do not increase, extend past a wall, do not begin at a left
/// wall or do not match the number of averages
/// @throws InputError when a density given as a function has no range of positive length
SampledDensity sample_density(const transform::Density& density,
                              const IntegrandBreakpoints& breaks);

}  // namespace fpkcheck::backward
