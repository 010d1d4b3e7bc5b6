#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/residual/reconstruction.hpp"
#include "transform/density.hpp"

namespace fpkcheck::backward {

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

/// A density at a wall.
struct SampledImpacts {
  SampledAxis speeds;  ///< u > 0, towards the wall
  Eigen::VectorXd samples;
};

/// A density as linear functionals see it: an integral of a(y) b(v) p is a product of a row, the
/// samples and a column.
struct SampledDensity {
  SampledAxis y, v;
  Eigen::MatrixXd samples;              ///< shape (samples along y, along v)
  std::vector<SampledImpacts> impacts;  ///< at each wall
};

/// Where what is integrated over impacts is not smooth.
struct ImpactBreaks {
  double position;             ///< of the wall
  double away;                 ///< 1 where y is larger than at the wall, -1 where it is less
  std::vector<double> speeds;  ///< increasing from 0
};

/// Where integrands are not smooth, increasing; rules are cut there.
struct IntegrandBreaks {
  std::span<const double> y, v;
  std::span<const ImpactBreaks> walls;
};

/// A density by Gauss's rule of six points between all breaks, its own and those of the integrands:
/// exact for splines of degree 5 times what reconstruction() makes of averages. Panels of a
/// function are no longer than a 24th of its range.
/// Where it ends before a wall there are no impacts.
/// @throws InputError when the edges do not increase, reach beyond a wall, do not begin at a left one
/// or do not fit the averages, and when the range of a function is not positive
SampledDensity sampled(const transform::Density& density, const IntegrandBreaks& breaks);

}  // namespace fpkcheck::backward
