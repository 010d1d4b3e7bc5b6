#include "epc/amplitude/circle.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::amplitude {

const std::array<double, kPhases>& phases() {
  static const auto list = [] {
    std::array<double, kPhases> angles{};
    for (int i = 0; i < kPhases; ++i) angles[i] = std::numbers::pi * (i / (kPhases - 1.0) - 0.5);
    return angles;
  }();
  return list;
}

double phase_weight(int phase) {
  constexpr double kStep = std::numbers::pi / (kPhases - 1);
  return (phase == 0 || phase == kPhases - 1 ? 0.5 : 1) * kStep;
}

double largest_at(const Exponent& exponent, double rho) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double theta : phases()) largest = std::max(largest, exponent(rho, theta));
  return largest;
}

Fall fall_of(const Exponent& exponent, double depth, double farthest) {
  constexpr int kSteps = 400;
  constexpr double kInside = 5;  // extrema above this depth are features of the density
  double peak = largest_at(exponent, 0), before = peak;
  for (int i = 1; i <= kSteps; ++i) {
    const double rho = farthest * i / kSteps;
    const double largest = largest_at(exponent, rho);
    peak = std::max(peak, largest);
    if (largest < peak - depth) return {rho, farthest};
    if (largest > before && before < peak - kInside) return {{}, farthest * (i - 1) / kSteps};
    before = largest;
  }
  return {{}, farthest};
}

}  // namespace fpkcheck::epc::amplitude
