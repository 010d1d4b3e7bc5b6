#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/residual/reconstruction.hpp"
#include "transform/density.hpp"

namespace fpkcheck::backward {

/// A quadrature rule along an axis for a density with `samples` along this axis: values at the
/// points, or averages over cells.
struct SampledAxis {
  std::vector<double> points;
  /// Maps samples to weight times density at the points: shape (points, samples).
  SparseRows weighted;

  /// Integrals of functions times the density, as linear forms of the samples.
  /// @param functions values at the points, shape (points, functions)
  /// @return shape (functions, samples)
  Eigen::MatrixXd integrals(const Eigen::MatrixXd& functions) const {
    return functions.transpose() * weighted;
  }
};

/// A density at a wall.
struct SampledImpacts {
  SampledAxis speeds;  ///< impact speeds u > 0
  Eigen::VectorXd samples;
};

/// A density, discretised for linear functionals: an integral of a(y) b(v) p is a row times the
/// matrix of samples times a column.
struct SampledDensity {
  SampledAxis y, v;
  Eigen::MatrixXd samples;              ///< shape (samples along y, along v)
  std::vector<SampledImpacts> impacts;  ///< at each wall
};

/// Impact speeds at which integrands over impacts at a wall are not smooth.
struct ImpactBreaks {
  double position;             ///< position of the wall
  double rebound_sign;         ///< ImpactWall::rebound_sign: 1 at a left wall, -1 at a right wall
  std::vector<double> speeds;  ///< increasing from 0
};

/// Points at which integrands are not smooth, increasing; the quadrature rules are divided there.
struct IntegrandBreaks {
  std::span<const double> y, v;
  std::span<const ImpactBreaks> walls;
};

/// Samples a density by the Gauss rule of six points between all breaks of the density and of the
/// integrands. The rule is exact for splines of degree 5 times the polynomials of
/// reconstruction_matrix(). For a density given as a function the panels are at most 1/24 of its
/// range. A density that ends before a wall has no impacts there.
/// @throws InputError when the edges do not increase, extend past a wall, do not begin at a left
/// wall or do not match the averages, and when the range of a function is not positive
SampledDensity sample_density(const transform::Density& density, const IntegrandBreaks& breaks);

}  // namespace fpkcheck::backward
