#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::backward {

/// Exception of a least-squares fit whose normal equations are not positive definite.
struct LeastSquaresFitFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Normal equations N x = b of a least-squares fit with the unknowns x. The matrix N of the normal
/// equations is scaled to a unit diagonal, regularised by adding 1e-13 to the diagonal (ridge), and
/// stored as a block-banded Cholesky factor.
class NormalEquations {
 public:
  /// Scales and factorises the matrix N of the normal equations.
  /// @param fit_name name of the fit in the error message
  /// @throws LeastSquaresFitFailure if the normal equations are not positive definite
  NormalEquations(numerics::BlockBandedMatrix matrix, const std::string& fit_name);

  /// Returns the solutions x of the normal equations for the right-hand sides b, both of shape
  /// (unknowns, right-hand sides).
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

  /// Returns the number of unknowns.
  Eigen::Index size() const { return diagonal_scaling_.size(); }

 private:
  numerics::BlockBandedMatrix factorised_matrix_;
  Eigen::VectorXd diagonal_scaling_;  // inverse square roots of the diagonal of N
};

}  // namespace fpkcheck::backward
