#include "backward/generator/normal_equations.hpp"

#include <utility>

namespace fpkcheck::backward {
namespace {

constexpr double kRidge = 1e-13;  // added to the unit diagonal

}  // namespace

NormalEquations::NormalEquations(numerics::BlockBandedMatrix matrix, const std::string& fit_name)
    : factorised_matrix_(std::move(matrix)),
      diagonal_scaling_(
          factorised_matrix_.diagonal().array().max(1e-300).sqrt().inverse().matrix()) {
  factorised_matrix_.scale_symmetrically(diagonal_scaling_);
  factorised_matrix_.add_to_diagonal(kRidge);
  if (!factorised_matrix_.factorise()) {
    throw LeastSquaresFitFailure("the normal equations of " + fit_name +
                                 " are not positive definite");
  }
}

Eigen::MatrixXd NormalEquations::solve(const Eigen::MatrixXd& right_hand_sides) const {
  Eigen::MatrixXd x = diagonal_scaling_.asDiagonal() * right_hand_sides;
  factorised_matrix_.solve_in_place(x);
  return diagonal_scaling_.asDiagonal() * x;
}

}  // namespace fpkcheck::backward
