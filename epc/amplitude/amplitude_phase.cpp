#include "epc/amplitude/amplitude_phase.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::amplitude {

const std::array<double, kPhaseCount>& equidistant_phases() {
  static const auto list = [] {
    std::array<double, kPhaseCount> angles{};
    for (int i = 0; i < kPhaseCount; ++i)
      angles[i] = std::numbers::pi * (i / (kPhaseCount - 1.0) - 0.5);
    return angles;
  }();
  return list;
}

double trapezoidal_phase_weight(int phase_index) {
  constexpr double kStep = std::numbers::pi / (kPhaseCount - 1);
  return (phase_index == 0 || phase_index == kPhaseCount - 1 ? 0.5 : 1) * kStep;
}

double maximum_over_phase(const ExponentInPolarCoordinates& exponent, double rho) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double theta : equidistant_phases()) largest = std::max(largest, exponent(rho, theta));
  return largest;
}

ExponentDecayRange find_exponent_decay_range(const ExponentInPolarCoordinates& exponent,
                                             double depth, double last_amplitude) {
  constexpr int kSteps = 400;
  // A minimum of the exponent less than kInside below the peak of the exponent is a feature of the
  // density, not the end of its decay.
  constexpr double kInside = 5;
  double peak = maximum_over_phase(exponent, 0), before = peak;
  for (int i = 1; i <= kSteps; ++i) {
    const double rho = last_amplitude * i / kSteps;
    const double largest = maximum_over_phase(exponent, rho);
    peak = std::max(peak, largest);
    if (largest < peak - depth) return {rho, last_amplitude};
    if (largest > before && before < peak - kInside) return {{}, last_amplitude * (i - 1) / kSteps};
    before = largest;
  }
  return {{}, last_amplitude};
}

numerics::QuadratureRule piecewise_gauss_legendre_rule(double end,
                                                       const std::vector<double>& breaks,
                                                       int point_count) {
  if (breaks.empty()) return numerics::gauss_legendre_rule(point_count, 0, end);
  numerics::QuadratureRule all;
  double from = 0;
  const auto add = [&](double to) {
    const auto panel = numerics::gauss_legendre_rule(
        static_cast<int>(point_count * (0.2 + (to - from) / end)) + 2, from, to);
    all.points.insert(all.points.end(), panel.points.begin(), panel.points.end());
    all.weights.conservativeResize(std::ssize(all.points));
    all.weights.tail(panel.size()) = panel.weights;
    from = to;
  };
  for (const double at : breaks) add(at);
  add(end);
  return all;
}

}  // namespace fpkcheck::epc::amplitude
