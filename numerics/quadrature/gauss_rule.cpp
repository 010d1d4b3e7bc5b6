#include "numerics/quadrature/gauss_rule.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cassert>
#include <cmath>
#include <numbers>

namespace fpkcheck::numerics {
namespace {

// Coefficients of the three-term recurrence of the orthonormal polynomials h_i, with h_0 = 1:
//
//     off_diagonal[i] h_{i+1}(t) = (t - diagonal[i]) h_i(t) - off_diagonal[i-1] h_{i-1}(t).
struct ThreeTermRecurrence {
  Eigen::VectorXd diagonal;
  Eigen::VectorXd off_diagonal;
};

// Computes a Gauss rule by the method of Golub and Welsch: the nodes are the eigenvalues of the
// Jacobi matrix. The weights 1 / sum_i h_i(t)^2 of a Gauss rule are computed from the three-term
// recurrence of the orthonormal polynomials h_i. Eigenvectors would not give the small weights of
// the outer nodes with full relative accuracy. Moments of degree 5n, where n is the closure order,
// require full relative accuracy of the weights.
QuadratureRule golub_welsch_rule(const ThreeTermRecurrence& recurrence) {
  const auto& [diagonal, off_diagonal] = recurrence;
  const Eigen::Index count = diagonal.size();
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(diagonal, off_diagonal.head(count - 1), Eigen::EigenvaluesOnly);
  QuadratureRule rule{{}, Eigen::VectorXd(count)};
  for (const double t : eigen.eigenvalues()) {
    double before = 0, h = 1, sum = 1;
    for (Eigen::Index i = 0; i + 1 < count; ++i) {
      const double carried = i > 0 ? off_diagonal[i - 1] * before : 0;
      const double next = ((t - diagonal[i]) * h - carried) / off_diagonal[i];
      before = h;
      h = next;
      sum += h * h;
    }
    rule.weights[std::ssize(rule.points)] = 1 / sum;
    rule.points.push_back(t);
  }
  return rule;
}

// With t = u^2 / 2 and a standard normal u, the expectation E[|u| g(u)] is the integral int_0^inf
// [g(sqrt(2t)) + g(-sqrt(2t))] exp(-t) dt / sqrt(2 pi), whose bracket is a polynomial in t of half
// the degree of g. The expectation E[sgn(u) g(u)] equals E[|u| g(u)/u], to which only the odd part
// of g contributes; the odd part of g divided by u is a polynomial in t.
const double kNormalDensityAtZero = 1 / std::sqrt(2 * std::numbers::pi);

}  // namespace

QuadratureRule gauss_legendre_rule(int point_count, double from, double to) {
  assert(point_count > 0);
  QuadratureRule rule{{}, Eigen::VectorXd(point_count)};
  for (const double zero : boost::math::legendre_p_zeros<double>(point_count)) {
    if (zero > 0) rule.points.push_back(-zero);
    rule.points.push_back(zero);
  }
  std::ranges::sort(rule.points);
  for (int i = 0; i < point_count; ++i) {
    double& x = rule.points[i];
    const double slope = boost::math::legendre_p_prime(point_count, x);
    rule.weights[i] = (to - from) / ((1 - x * x) * slope * slope);
    x = (from + to) / 2 + (to - from) / 2 * x;
  }
  return rule;
}

QuadratureRule gauss_laguerre_rule(int degree) {
  const int count = degree / 2 + 1;
  const Eigen::VectorXd i = Eigen::VectorXd::LinSpaced(count, 0, count - 1);
  return golub_welsch_rule({(2 * i).array() + 1, i.array() + 1});
}

QuadratureRule gauss_hermite_rule(int degree) {
  const int count = degree / 2 + 1;
  const Eigen::VectorXd i = Eigen::VectorXd::LinSpaced(count, 0, count - 1);
  return golub_welsch_rule({Eigen::VectorXd::Zero(count), (i.array() + 1).sqrt()});
}

QuadratureRule normal_rule_weighted_by_abs(int degree) {
  const QuadratureRule half = gauss_laguerre_rule(degree / 2);
  QuadratureRule rule{{}, Eigen::VectorXd(2 * half.size())};
  for (Eigen::Index i = 0; i < half.size(); ++i) {
    const double u = std::sqrt(2 * half.points[i]);
    rule.points.insert(rule.points.end(), {u, -u});
    rule.weights.segment<2>(2 * i).setConstant(half.weights[i] * kNormalDensityAtZero);
  }
  return rule;
}

QuadratureRule normal_rule_weighted_by_sign(int degree) {
  QuadratureRule rule = normal_rule_weighted_by_abs(degree);
  for (Eigen::Index i = 0; i < rule.size(); ++i) rule.weights[i] /= rule.points[i];
  return rule;
}

}  // namespace fpkcheck::numerics
