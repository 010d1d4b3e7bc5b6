#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::backward {

/// Exception for normal equations without a Cholesky factor.
struct FitFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Normal equations of a least-squares fit, scaled to a unit diagonal, regularised by a ridge of
/// 1e-13 and stored as a block-banded Cholesky factor.
class NormalEquations {
 public:
  /// @param fit_name name of the fit in the error message, such as "the fit"
  /// @throws FitFailure "the normal equations of `fit_name` are not positive definite"
  NormalEquations(numerics::BlockBandedMatrix matrix, const std::string& fit_name);

  /// @param right shape (unknowns, right-hand sides)
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

  Eigen::Index size() const { return scale_.size(); }

 private:
  numerics::BlockBandedMatrix matrix_;
  Eigen::VectorXd scale_;
};

}  // namespace fpkcheck::backward
