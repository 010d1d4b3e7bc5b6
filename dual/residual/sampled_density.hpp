#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dual/residual/reconstruction.hpp"
#include "transform/density.hpp"

namespace fpkcheck::dual {

/// A quadrature rule along an axis, for a density of which `samples` are known along it: its values
/// at the points, or its averages over cells.
struct SampledAxis {
  std::vector<double> points;
  /// The weight of a point times the density there, from the samples: shape (points, samples).
  SparseRows weighted;

  /// The integrals of functions times the density.
  /// @param functions values at the points, shape (points, functions)
  /// @return shape (functions, samples)
  Eigen::MatrixXd integrals(const Eigen::MatrixXd& functions) const {
    return functions.transpose() * weighted;
  }
};

/// A density as linear functionals see it: an integral of a(y) b(v) p is a product of a row, the
/// samples and a column.
struct SampledDensity {
  SampledAxis y, v;
  Eigen::MatrixXd samples;  ///< shape (samples along y, along v)
  /// The speeds u of impacts, 0 < u.
  SampledAxis wall;
  Eigen::VectorXd wall_samples;  ///< of p(0, -u)
};

/// Where integrands are not smooth, increasing; rules are cut there.
struct IntegrandBreaks {
  std::span<const double> y, v;
  std::span<const double> wall;  ///< speeds of impacts, from 0 on
};

/// A density by Gauss's rule of six points between all breaks, its own and those of the integrands:
/// exact for splines of degree 5 times what reconstruction() makes of averages. Panels of a
/// function are no longer than a 24th of its range.
/// @throws InputError when the edges do not increase, do not begin at y = 0 or do not fit the
/// averages, and when the range of a function is not positive
SampledDensity sampled(const transform::Density& density, const IntegrandBreaks& breaks);

}  // namespace fpkcheck::dual
