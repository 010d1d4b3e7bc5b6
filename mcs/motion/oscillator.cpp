#include "mcs/motion/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/input_error.hpp"
#include "problem/system.hpp"

namespace fpkcheck::mcs {
namespace {

using numerics::Polynomial;

Polynomial make_slope_bound(const Polynomial& force) {
  Polynomial::Coefficients magnitudes{};
  for (std::size_t n = 0; n < magnitudes.size(); ++n) {
    magnitudes[n] = std::abs(force.coefficient(n));
  }
  return Polynomial(magnitudes).derivative();
}

/// Coefficients r_j of U(y) / (u_m y^m) = sum_j r_j w^j with w = 1/y, r_j = u_(m-j) / u_m and the
/// degree m of U.
Polynomial ratio_to_last_term(const Polynomial& potential) {
  const std::size_t m = potential.degree();
  Polynomial::Coefficients r{};
  for (std::size_t j = 0; j <= m; ++j) {
    r[j] = potential.coefficient(m - j) / potential.coefficient(m);
  }
  return Polynomial(r);
}

/// Absolute values of the terms with one sign.
Polynomial terms(const Polynomial& p, double sign) {
  Polynomial::Coefficients part{};
  for (std::size_t j = 0; j < part.size(); ++j) part[j] = std::max(0.0, sign * p.coefficient(j));
  return Polynomial(part);
}

/// Value of w above which the last term of `ratio`, which is positive, exceeds the sum of all
/// negative terms.
double dominance_threshold(const Polynomial& ratio) {
  const std::size_t last = ratio.degree();
  double w = 0;
  for (std::size_t j = 0; j < last; ++j) {
    const double share =
        static_cast<double>(last) * -ratio.coefficient(j) / ratio.coefficient(last);
    if (share > 0) w = std::max(w, std::pow(share, 1 / static_cast<double>(last - j)));
  }
  return w;
}

/// Tight lower bound of U(y) / (u_m y^m) over y > 0. Without negative terms the bound is 1. If the
/// energy does not bound the motion, the bound is 0 or negative.
double ratio_lower_bound(const Polynomial& potential) {
  constexpr double kFineness = 1.001, kNegligible = 1e-3;
  const Polynomial ratio = ratio_to_last_term(potential);
  const Polynomial positive = terms(ratio, 1), negative = terms(ratio, -1);
  if (negative.degree() == 0) return 1;
  if (ratio.coefficient(ratio.degree()) < 0) return 0;
  // The sums of positive and of negative terms both increase with w. On [a, b] the ratio is
  // therefore at least positive(a) - negative(b). Near w = 0 the positive part is 1.
  double least = 1 - kNegligible;
  for (double b = dominance_threshold(ratio); negative(b) > kNegligible && least > 0;
       b /= kFineness) {
    least = std::min(least, positive(b / kFineness) - negative(b));
  }
  return least;
}

void require_bounded_motion(const Oscillator& oscillator) {
  if (oscillator.force.coefficient(0) != 0) {
    throw InputError(
        "spring force not 0 at the wall: impacts may accumulate; use a force that is 0 at y = 0, "
        "or another method");
  }
  if (!(oscillator.potential_bound > 0)) {
    throw InputError(
        "spring potential not positive for all y > 0: no energy bounds the motion; change the "
        "coefficients, or use another method");
  }
}

}  // namespace

Oscillator::Oscillator(const problem::System& system)
    : Oscillator(system.damping(), system.restitution(), system.restoring_force()) {}

Oscillator::Oscillator(double c, double r, const Polynomial& spring)
    : damping(c),
      restitution(r),
      force(spring),
      potential(spring.antiderivative()),
      degree(static_cast<int>(force.degree())),
      is_duffing(force.coefficient(0) == 0 && force.coefficient(2) == 0 && degree <= 3),
      stiffness(force.coefficient(1)),
      cubic(force.coefficient(3)),
      slope_bound(make_slope_bound(force)),
      potential_bound(potential.coefficient(potential.degree()) * ratio_lower_bound(potential)) {
  require_bounded_motion(*this);
}

}  // namespace fpkcheck::mcs
