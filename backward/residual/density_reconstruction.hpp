#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "transform/joint_density.hpp"

namespace fpkcheck::backward {

using RowMajorSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Returns the matrix that maps n cell averages of a density to values of the density at points,
/// shape (points, n). The values are slopes of the cumulative distribution, which polynomials of
/// degree 7 interpolate between the edges (as in transform::ConservativeRemap). Each cell therefore
/// keeps its mass, and the values of a smooth density have an error of seventh order in the cell
/// width. No stencil crosses an edge at 0. A point on an edge belongs to the cell above the edge. A
/// point on the last edge belongs to the last cell. Values beyond the first and the last edge are
/// 0.
/// @param edges n + 1 increasing cell edges
RowMajorSparseMatrix density_reconstruction_matrix(std::span<const double> edges,
                                                   std::span<const double> points);

/// Quadrature rule along one axis for a density that is given by samples. The samples are values of
/// the density at the points, or averages over cells.
struct DensityAxisQuadrature {
  std::vector<double> points;
  /// Matrix of shape (points, samples) that maps the samples to the products of the quadrature
  /// weight and the density at the points
  RowMajorSparseMatrix weighted_density_matrix;

  /// Returns the integrals of each function times the density, as linear forms of the samples,
  /// shape (functions, samples).
  /// @param function_values values of the functions at the points, shape (points, functions)
  Eigen::MatrixXd integrals_of_functions_times_density(
      const Eigen::MatrixXd& function_values) const {
    return function_values.transpose() * weighted_density_matrix;
  }
  /// Returns integrals_of_functions_times_density() as a sparse matrix, for functions with a small
  /// support, such as splines.
  RowMajorSparseMatrix sparse_integrals_times_density(
      const Eigen::MatrixXd& function_values) const {
    return RowMajorSparseMatrix(function_values.transpose().sparseView()) * weighted_density_matrix;
  }
};

/// Density p(wall, v) before an impact at a wall, as a function of the impact speed.
struct SampledWallDensity {
  DensityAxisQuadrature speed_quadrature;
  Eigen::VectorXd samples;  ///< samples of the density along the axis of the impact speed
};

/// Density p(y, v) given by samples. With the linear forms a and b of
/// integrals_of_functions_times_density() for a function of y and a function of v, the integral of
/// both functions times p is a^T samples b.
struct SampledDensity {
  DensityAxisQuadrature y_quadrature, v_quadrature;
  Eigen::MatrixXd samples;  ///< samples of the density, shape (samples along y, samples along v)
  std::vector<SampledWallDensity> wall_densities;  ///< density at each wall of IntegrandBreakpoints
};

/// Impact speeds at which integrands over the impacts at a wall are not smooth.
struct ImpactSpeedBreakpoints {
  double wall_position;
  /// WallWithRestitution::rebound_sign: 1 at a left wall, -1 at a right wall
  double rebound_sign;
  std::vector<double> breaks;  ///< impact speeds, increasing from 0
};

/// Increasing points at which integrands are not smooth, and at which the panels of the quadrature
/// rules end.
struct IntegrandBreakpoints {
  std::span<const double> y_breaks, v_breaks;
  std::span<const ImpactSpeedBreakpoints> impact_breaks;  ///< one element for each wall
};

/// Samples a density at the points of a Gauss rule of six points between all breaks of the density
/// and of the integrands. The rule is exact for the product of a spline of degree 5 and a
/// polynomial of density_reconstruction_matrix(). For a density given as a function no panel is
/// longer than 1/24 of the range. The density at a wall that is outside the range of the density is
/// 0.
/// @throws InputError when the edges do not increase, extend past a wall, do not begin at a left
/// wall or do not match the number of averages
/// @throws InputError when a density given as a function has no range of positive length
SampledDensity sample_density(const transform::Density& density,
                              const IntegrandBreakpoints& breaks);

}  // namespace fpkcheck::backward
