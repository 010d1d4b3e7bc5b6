#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "epc/half_plane/basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// Function that returns the coordinates s and t of QuadraturePoints from w = sqrt(2 V(y)) and a
/// velocity v.
using CoordinateMap = std::function<std::pair<double, double>(double w, double v)>;

/// Means E[phi(y, v + Y)] of every basis function phi after an impulse Y. The shape is (number of
/// points, number of basis functions). Near v = 0 the basis functions vary over a width w, see
/// GradedImpulseQuadrature.
/// @param w,v values of w and v at the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law, const half_plane::Basis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const CoordinateMap& coordinates);

}  // namespace fpkcheck::epc::amplitude
