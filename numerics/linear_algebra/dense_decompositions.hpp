#pragma once

#include <Eigen/Core>
#include <memory>

/// LU factorisation and singular values of dense matrices.
namespace fpkcheck::numerics {

/// LU factors of a square matrix, computed with partial pivoting. Only the source file of this
/// class includes Eigen's decomposition, so that the decomposition is compiled once.
class LuFactors {
 public:
  explicit LuFactors(const Eigen::MatrixXd& matrix);
  LuFactors(LuFactors&&) noexcept;
  LuFactors& operator=(LuFactors&&) noexcept;
  ~LuFactors();

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  double determinant() const;

 private:
  std::unique_ptr<Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

/// Singular values of a matrix, in decreasing order.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// Indicators of a nearly singular square matrix.
struct SingularityIndicators {
  double smallest_singular_value;
  int determinant_sign;  ///< sign of the determinant: -1, 0 or 1
};
SingularityIndicators singularity_indicators(const Eigen::MatrixXd& matrix);

}  // namespace fpkcheck::numerics
