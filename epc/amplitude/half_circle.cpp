#include "epc/amplitude/half_circle.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::amplitude {

const std::array<double, kPhaseCount>& phases() {
  static const auto list = [] {
    std::array<double, kPhaseCount> angles{};
    for (int i = 0; i < kPhaseCount; ++i)
      angles[i] = std::numbers::pi * (i / (kPhaseCount - 1.0) - 0.5);
    return angles;
  }();
  return list;
}

double phase_weight(int phase) {
  constexpr double kStep = std::numbers::pi / (kPhaseCount - 1);
  return (phase == 0 || phase == kPhaseCount - 1 ? 0.5 : 1) * kStep;
}

double maximum_over_phase(const Exponent& exponent, double rho) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double theta : phases()) largest = std::max(largest, exponent(rho, theta));
  return largest;
}

DecayScan scan_decay(const Exponent& exponent, double depth, double farthest) {
  constexpr int kSteps = 400;
  // Minima at a depth of less than kInside below the peak are features of the density.
  constexpr double kInside = 5;
  double peak = maximum_over_phase(exponent, 0), before = peak;
  for (int i = 1; i <= kSteps; ++i) {
    const double rho = farthest * i / kSteps;
    const double largest = maximum_over_phase(exponent, rho);
    peak = std::max(peak, largest);
    if (largest < peak - depth) return {rho, farthest};
    if (largest > before && before < peak - kInside) return {{}, farthest * (i - 1) / kSteps};
    before = largest;
  }
  return {{}, farthest};
}

}  // namespace fpkcheck::epc::amplitude
