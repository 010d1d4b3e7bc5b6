#include "approximations/cumulant/bivariate_polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::cumulant {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int kDegree = 6;  // that of numerics::Polynomial

// Powers t^0, .. t^6 of the Chebyshev points of [-1, 1] in the rows of a matrix.
MatrixXd powers_of_chebyshev_points() {
  MatrixXd powers(kDegree + 1, kDegree + 1);
  for (int k = 0; k <= kDegree; ++k) {
    const double t = std::cos(std::numbers::pi * (2 * k + 1) / (2 * (kDegree + 1)));
    for (int i = 0; i <= kDegree; ++i) powers(k, i) = std::pow(t, i);
  }
  return powers;
}

// Solves V X = B for every column of B.
MatrixXd solve_columns(const numerics::LuFactors& factors, const MatrixXd& right) {
  MatrixXd solution(right.rows(), right.cols());
  for (Index k = 0; k < right.cols(); ++k) solution.col(k) = factors.solve(right.col(k));
  return solution;
}

// Returns the matrix T with t^i = sum_k T(i, k) x^k for t = (x - centre) / half_width.
MatrixXd powers_in_original_variable(double centre, double half_width) {
  MatrixXd powers = MatrixXd::Zero(kDegree + 1, kDegree + 1);
  powers(0, 0) = 1;
  for (int i = 0; i < kDegree; ++i) {
    powers.row(i + 1).tail(kDegree) = powers.row(i).head(kDegree) / half_width;
    powers.row(i + 1) -= centre / half_width * powers.row(i);
  }
  return powers;
}

}  // namespace

double evaluate_polynomial(const MatrixXd& coefficients, double x, double w) {
  double value = 0;
  for (Index i = coefficients.rows(); i-- > 0;) {
    double row = 0;
    for (Index j = coefficients.cols(); j-- > 0;) row = row * w + coefficients(i, j);
    value = value * x + row;
  }
  return value;
}

std::optional<MatrixXd> fit_polynomial(const std::function<double(double, double)>& f,
                                       const Rectangle& rectangle) {
  // Rounding errors of interpolation are below kRounding; other functions differ by far more.
  constexpr double kRounding = 1e-12, kTolerance = 1e-10;
  constexpr int kTestPoints = 15;
  const auto x_of = [&](double t) {
    return std::lerp(rectangle.x_low, rectangle.x_high, (1 + t) / 2);
  };
  const auto w_of = [&](double t) {
    return std::lerp(rectangle.w_low, rectangle.w_high, (1 + t) / 2);
  };
  const MatrixXd powers = powers_of_chebyshev_points();
  MatrixXd values(kDegree + 1, kDegree + 1);
  for (int i = 0; i <= kDegree; ++i) {
    for (int j = 0; j <= kDegree; ++j) values(i, j) = f(x_of(powers(i, 1)), w_of(powers(j, 1)));
  }
  const numerics::LuFactors factors(powers);
  MatrixXd scaled = solve_columns(factors, solve_columns(factors, values).transpose()).transpose();
  const double largest = std::max(values.cwiseAbs().maxCoeff(), 1e-300);
  scaled = (scaled.array().abs() < kRounding * largest).select(0, scaled);

  for (int i = 0; i <= kTestPoints; ++i) {
    for (int j = 0; j <= kTestPoints; ++j) {
      const double s = 2.0 * i / kTestPoints - 1, t = 2.0 * j / kTestPoints - 1;
      const double error = f(x_of(s), w_of(t)) - evaluate_polynomial(scaled, s, t);
      if (!(std::abs(error) <= kTolerance * largest)) return std::nullopt;
    }
  }
  const auto in_original = [](double low, double high) {
    return powers_in_original_variable((low + high) / 2, (high - low) / 2);
  };
  return in_original(rectangle.x_low, rectangle.x_high).transpose() * scaled *
         in_original(rectangle.w_low, rectangle.w_high);
}

}  // namespace fpkcheck::cumulant
