#pragma once

#include <Eigen/Core>
#include <memory>

/// LU factorisation and singular values of dense matrices.
namespace fpkcheck::numerics {

/// LU factors of a square matrix with partial pivoting. Eigen's class is compiled once, behind
/// this.
class Factors {
 public:
  explicit Factors(const Eigen::MatrixXd& matrix);
  Factors(Factors&&) noexcept;
  Factors& operator=(Factors&&) noexcept;
  ~Factors();

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  double determinant() const;

 private:
  std::unique_ptr<Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

/// Singular values in decreasing order.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// Indicators of a nearly singular square matrix.
struct Regularity {
  double smallest_singular_value;
  int determinant_sign;  ///< -1, 0 or 1
};
Regularity regularity(const Eigen::MatrixXd& matrix);

}  // namespace fpkcheck::numerics
