#pragma once

#include <Eigen/Core>
#include <memory>

/// Roots of systems of equations: Newton's method and curves of solutions. Nothing here knows what
/// the equations are of.
namespace fpkcheck::numerics {

/// LU factors of a square matrix. (Eigen's own are compiled once, behind this.)
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

/// Decreasing.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// How near a square matrix is to a singular one.
struct Regularity {
  double smallest_singular_value;
  int determinant_sign;  ///< -1, 0 or 1
};
Regularity regularity(const Eigen::MatrixXd& matrix);

}  // namespace fpkcheck::numerics
