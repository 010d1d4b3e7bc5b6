#include "exact/random_acceleration.hpp"

#include <cmath>

namespace fpkcheck::exact {
namespace {

// The series of 2F1(1, -1/3; 7/6; x) for 0 <= x < 1
double hypergeometric_of_exit(double x) {
  double sum = 0, term = 1;
  for (int n = 0; std::abs(term) > 1e-17; ++n) {
    sum += term;
    term *= (n - 1. / 3) / (n + 7. / 6) * x;
  }
  return sum;
}

}  // namespace

double random_acceleration_exit_time(double part, double length, double diffusion) {
  return std::cbrt(length * length / diffusion) * std::pow(4. / 3, 1. / 6) / std::tgamma(7. / 3) *
         std::pow(part * (1 - part), 1. / 6) *
         (hypergeometric_of_exit(part) + hypergeometric_of_exit(1 - part));
}

}  // namespace fpkcheck::exact
