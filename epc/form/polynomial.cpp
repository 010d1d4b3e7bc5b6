#include "epc/form/polynomial.hpp"

#include <algorithm>

namespace fpkcheck::epc {

Polynomial::Polynomial(std::vector<Term> terms) : terms_(std::move(terms)), degree_(0) {
  for (const auto& [p, q, a] : terms_) degree_ = std::max(degree_, p + q);
  for (int p = degree_; p >= 0; --p) {
    for (int q = degree_ - p; q >= 0; --q) {
      double coefficient = 0;
      for (const Term& term : terms_) {
        if (term.x1 == p && term.x2 == q) coefficient += term.a;
      }
      triangle_.push_back(coefficient);
    }
  }
}

double Polynomial::operator()(double x1, double x2) const {
  double value = 0;
  const double* coefficient = triangle_.data();
  for (int p = degree_; p >= 0; --p) {
    double row = 0;
    for (int q = degree_ - p; q >= 0; --q) row = row * x2 + *coefficient++;
    value = value * x1 + row;
  }
  return value;
}

std::vector<double> Polynomial::restriction_to_ray(double e1, double e2) const {
  std::vector<double> power1{1}, power2{1};
  for (int m = 1; m <= degree_; ++m) {
    power1.push_back(power1.back() * e1);
    power2.push_back(power2.back() * e2);
  }
  std::vector<double> coefficients(degree_ + 1);
  for (const auto& [p, q, a] : terms_) coefficients[p + q] += a * power1[p] * power2[q];
  return coefficients;
}

std::vector<double> derivative_coefficients(const std::vector<double>& coefficients) {
  std::vector<double> result;
  for (std::size_t m = 1; m < coefficients.size(); ++m) {
    result.push_back(static_cast<double>(m) * coefficients[m]);
  }
  return result;
}

}  // namespace fpkcheck::epc
