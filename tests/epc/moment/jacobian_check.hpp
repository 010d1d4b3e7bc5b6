#pragma once

#include <gtest/gtest.h>

#include "epc/moment/galerkin.hpp"

namespace fpkcheck::tests {

/// The analytic Jacobian of Galerkin equations against central differences of their residual.
inline void expect_jacobian_is_derivative(const epc::moment::Galerkin& equations,
                                          const Eigen::VectorXd& a) {
  constexpr double kStep = 1e-5;
  const Eigen::MatrixXd jacobian = equations.jacobian(equations.density(a));
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(a.size(), k);
    const Eigen::VectorXd difference = (equations.residual(equations.density(a + e)) -
                                        equations.residual(equations.density(a - e))) /
                                       (2 * kStep);
    EXPECT_LT((jacobian.col(k) - difference).cwiseAbs().maxCoeff(),
              1e-7 * (1 + difference.cwiseAbs().maxCoeff()))
        << k;
  }
}

}  // namespace fpkcheck::tests
