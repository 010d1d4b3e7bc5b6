#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "epc/half_plane/basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// Map from w = sqrt(2 V(y)) and a velocity v to the coordinates s and t of QuadraturePoints.
using CoordinateMap = std::function<std::pair<double, double>(double w, double v)>;

/// E[phi(y, v + Y)] of every member of a basis: shape (points, members). Near v = 0 the members
/// vary over a width w (GradedImpulseRule).
/// @param w, v at the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law, const half_plane::Basis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const CoordinateMap& coordinates);

}  // namespace fpkcheck::epc::amplitude
