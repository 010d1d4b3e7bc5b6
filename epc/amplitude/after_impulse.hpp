#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "epc/half_plane/basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// The coordinates s and t of a velocity where w = sqrt(2 V(y)).
using AtVelocity = std::function<std::pair<double, double>(double w, double v)>;

/// E[phi(y, v + Y)] of every member of a basis: shape (points, members). The members change with v
/// over a width w about 0 (GradedImpulseRule).
/// @param w, v of the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law, const half_plane::Basis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const AtVelocity& coordinates);

}  // namespace fpkcheck::epc::amplitude
