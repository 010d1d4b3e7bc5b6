#pragma once

namespace fpkcheck::numerics {

/// A number a + b e with e^2 = 0. Arithmetic with dual numbers computes the value of an expression
/// and its derivative (forward differentiation).
struct DualNumber {
  double value = 0;
  double derivative = 0;

  friend constexpr DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  friend constexpr DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  friend constexpr DualNumber operator-(const DualNumber& a) { return {-a.value, -a.derivative}; }
  friend constexpr DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
  }
  friend constexpr DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
};

}  // namespace fpkcheck::numerics
