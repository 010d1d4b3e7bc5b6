#include "backward/generator/normal_equations.hpp"

#include <utility>

namespace fpkcheck::backward {
namespace {

constexpr double kRidge = 1e-13;

}  // namespace

NormalEquations::NormalEquations(numerics::BlockBandedMatrix matrix, const std::string& fit_name)
    : matrix_(std::move(matrix)),
      scale_(matrix_.diagonal().array().max(1e-300).sqrt().inverse().matrix()) {
  matrix_.scale_symmetrically(scale_);
  matrix_.add_to_diagonal(kRidge);
  if (!matrix_.factorise()) {
    throw FitFailure("the normal equations of " + fit_name + " are not positive definite");
  }
}

Eigen::MatrixXd NormalEquations::solve(const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd x = scale_.asDiagonal() * right;
  matrix_.solve_in_place(x);
  return scale_.asDiagonal() * x;
}

}  // namespace fpkcheck::backward
