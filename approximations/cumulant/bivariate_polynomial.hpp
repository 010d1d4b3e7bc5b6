#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace fpkcheck::cumulant {

/// Evaluates a polynomial sum_ij a_ij x^i w^j with the coefficients a_ij.
double evaluate_polynomial(const Eigen::MatrixXd& coefficients, double x, double w);

/// Rectangle of two variables.
struct Rectangle {
  double x_low, x_high, w_low, w_high;
};

/// Returns the coefficients a_ij of a function f(x, w) = sum_ij a_ij x^i w^j, i and j <= 6; nullopt
/// if the function differs from its interpolating polynomial at points of the rectangle. The
/// samples of a formula decide, since the square of a noise factor such as sqrt(1 + y^2) is a
/// polynomial although the formula is none.
std::optional<Eigen::MatrixXd> fit_polynomial(const std::function<double(double, double)>& f,
                                              const Rectangle& rectangle);

}  // namespace fpkcheck::cumulant
