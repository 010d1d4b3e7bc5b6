#include "numerics/linear_algebra/dense_decompositions.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace fpkcheck::numerics {

LuFactors::LuFactors(const Eigen::MatrixXd& matrix)
    : lu_(std::make_unique<Eigen::PartialPivLU<Eigen::MatrixXd>>(matrix)) {}
LuFactors::LuFactors(LuFactors&&) noexcept = default;
LuFactors& LuFactors::operator=(LuFactors&&) noexcept = default;
LuFactors::~LuFactors() = default;

Eigen::VectorXd LuFactors::solve(const Eigen::VectorXd& right) const { return lu_->solve(right); }
double LuFactors::determinant() const { return lu_->determinant(); }

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return matrix.jacobiSvd().singularValues();
}

SingularityIndicators singularity_indicators(const Eigen::MatrixXd& matrix) {
  const double determinant = LuFactors(matrix).determinant();
  return {.smallest_singular_value = singular_values(matrix).minCoeff(),
          .determinant_sign = determinant > 0   ? 1
                              : determinant < 0 ? -1
                                                : 0};
}

}  // namespace fpkcheck::numerics
