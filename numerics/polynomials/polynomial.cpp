#include "numerics/polynomials/polynomial.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::numerics {

std::vector<double> sign_change_points(const Polynomial& polynomial, double low, double high) {
  if (polynomial.degree() == 0) return {};
  std::vector<double> ends{low};
  for (const double turn : sign_change_points(polynomial.derivative(), low, high))
    ends.push_back(turn);
  ends.push_back(high);
  std::vector<double> roots;
  for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
    const double from = polynomial(ends[n]), to = polynomial(ends[n + 1]);
    if (from == 0 && n > 0 && (polynomial(ends[n - 1]) < 0) != (to < 0)) roots.push_back(ends[n]);
    if (from == 0 || to == 0 || (from < 0) == (to < 0)) continue;
    roots.push_back(bracketed_root(polynomial, ends[n], ends[n + 1]));
  }
  return roots;
}

double root_modulus_bound(const Polynomial& polynomial) {
  const std::size_t degree = polynomial.degree();
  if (degree == 0) return 0;
  double largest = 0;
  for (std::size_t n = 0; n < degree; ++n) {
    largest =
        std::max(largest, std::abs(polynomial.coefficient(n) / polynomial.coefficient(degree)));
  }
  return 1 + largest;
}

}  // namespace fpkcheck::numerics
