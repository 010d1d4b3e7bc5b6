#include "numerics/linear_algebra/dense.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace fpkcheck::numerics {

Factors::Factors(const Eigen::MatrixXd& matrix)
    : lu_(std::make_unique<Eigen::PartialPivLU<Eigen::MatrixXd>>(matrix)) {}
Factors::Factors(Factors&&) noexcept = default;
Factors& Factors::operator=(Factors&&) noexcept = default;
Factors::~Factors() = default;

Eigen::VectorXd Factors::solve(const Eigen::VectorXd& right) const { return lu_->solve(right); }
double Factors::determinant() const { return lu_->determinant(); }

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return matrix.jacobiSvd().singularValues();
}

Regularity regularity(const Eigen::MatrixXd& matrix) {
  const double determinant = Factors(matrix).determinant();
  return {.smallest_singular_value = singular_values(matrix).minCoeff(),
          .determinant_sign = determinant > 0   ? 1
                              : determinant < 0 ? -1
                                                : 0};
}

}  // namespace fpkcheck::numerics
