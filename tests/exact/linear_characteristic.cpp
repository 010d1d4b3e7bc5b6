#include "exact/linear_characteristic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "exact/law_transforms.hpp"

namespace fpkcheck::exact {
namespace {

using std::numbers::pi;

const problem::Problem& require_linear_and_symmetric(const problem::Problem& problem) {
  const auto require = [](bool holds, const char* key, double value, const char* requirement) {
    if (holds) return;
    throw InputError(fmt::format("{} = {}: the exact density of the linear oscillator requires {}",
                                 key, value, requirement));
  };
  const auto& system = problem.system;
  const auto& impulses = problem.impulses;
  require(system.has_linear_force(), "system.cubic", system.restoring_force().coefficient(3), "0");
  require(system.restitution() == 1, "system.restitution", system.restitution(), "1");
  require(system.damping() * system.damping() < 4 * system.stiffness(), "system.damping",
          system.damping(), "less than critical damping, 2 sqrt(stiffness)");
  require(impulses.amplitude_law().mean() == 0, "impulse.mean", impulses.amplitude_law().mean(),
          "0");
  require(impulses.amplitude_law().is_symmetric(), "impulse.skewness",
          impulses.amplitude_law().skewness(), "0");
  return problem;
}

// Chebyshev points of the second kind on [0, 1].
double chebyshev_point(int n, int order) { return (1 - std::cos(pi * n / order)) / 2; }

// The polynomial through `values` at the Chebyshev points, by the barycentric formula.
template <std::size_t Points>
double chebyshev_interpolant(const std::array<double, Points>& values, double x) {
  constexpr int kOrder = static_cast<int>(Points) - 1;
  double above = 0, below = 0;
  for (int n = 0; n <= kOrder; ++n) {
    const double distance = x - chebyshev_point(n, kOrder);
    if (distance == 0) return values[n];
    const double weight = (n % 2 ? -1 : 1) * (n == 0 || n == kOrder ? 0.5 : 1) / distance;
    above += weight * values[n];
    below += weight;
  }
  return above / below;
}

}  // namespace

LinearCharacteristicFunction::LinearCharacteristicFunction(const problem::Problem& problem)
    : system_(require_linear_and_symmetric(problem).system),
      impulses_(problem.impulses),
      scale_(impulses_.amplitude_law().amplitude_standard_deviation()) {
  tabulate();
}

double LinearCharacteristicFunction::operator()(double u1, double u2) const {
  return std::exp(logarithm(u1, u2));
}

double LinearCharacteristicFunction::radius(double u1, double u2) const {
  return impulse_response(system_, u1, u2).amplitude;
}

double LinearCharacteristicFunction::logarithm(double u1, double u2) const {
  const DecayingWave wave = impulse_response(system_, u1, u2);
  const double zero = wave.first_zero();
  return integrate_wave(wave, zero) + logarithm_from_zero(wave.envelope(zero));
}

double LinearCharacteristicFunction::max_beyond(double radius) const {
  constexpr int kDirections = 32;  // over half a turn, as phi is even
  const double c = system_.damping();
  const double w = std::sqrt(system_.stiffness() - c * c / 4);
  double largest = -HUGE_VAL;
  for (int n = 0; n < kDirections; ++n) {
    const double angle = pi * n / kDirections;
    const double u2 = radius * std::sin(angle);
    largest = std::max(largest, logarithm(w * radius * std::cos(angle) + c * u2 / 2, u2));
  }
  return std::exp(largest);
}

// The integral lambda int_0^end ( M(wave(t)) - 1 ) dt.
double LinearCharacteristicFunction::integrate_wave(const DecayingWave& wave, double end) const {
  const auto excess = [this](double u) {
    return characteristic_function(impulses_.amplitude_law(), u).real() - 1;
  };
  return impulses_.arrival_rate() * integrate_along_wave(wave, excess, scale_, end);
}

// The logarithm for a wave with phase 0.
double LinearCharacteristicFunction::logarithm_from_zero(double amplitude) const {
  return integrate_from_zero(amplitude, static_cast<double>(panels_.size()) / scale_);
}

// Integrates over half-cycles of the wave until the amplitude is in the range of the table, or
// small enough for the series in moments.
double LinearCharacteristicFunction::integrate_from_zero(double amplitude, double table_end) const {
  constexpr double kSmall = 0.02;  // the first omitted term is at most (0.02)^8 / 16
  const double tabulated = std::max(table_end, kSmall / scale_);
  const double c = system_.damping();
  const DecayingWave wave{amplitude, 0, c, std::sqrt(system_.stiffness() - c * c / 4)};
  const double half_periods =
      amplitude > tabulated
          ? std::ceil(std::log(amplitude / tabulated) / (c * wave.half_period() / 2))
          : 0;
  const double end = half_periods * wave.half_period();
  const double left = std::min(wave.envelope(end), tabulated);
  return integrate_wave(wave, end) +
         (table_end > 0 ? interpolate_table(left) : small_amplitude_series(left));
}

// The sum over j = 2, 4, 6 of
// (-1)^(j/2) lambda E[Y^j]/j! a^j int_0^inf exp(-j c t / 2) sin^j(wt) dt.
double LinearCharacteristicFunction::small_amplitude_series(double amplitude) const {
  const double c = system_.damping();
  const double w2 = system_.stiffness() - c * c / 4;
  double sum = 0;
  for (int j = 2; j < problem::kMomentCount; j += 2) {
    const double rate = j * c / 2;
    // The integral is j! w^j / ( rate prod_{m=1}^{j/2} (rate^2 + (2 m w)^2) ); j! cancels.
    double term =
        impulses_.rate_times_moment(j) * std::pow(-amplitude * amplitude * w2, j / 2) / rate;
    for (int m = 1; m <= j / 2; ++m) term /= rate * rate + 4 * m * m * w2;
    sum += term;
  }
  return sum;
}

double LinearCharacteristicFunction::interpolate_table(double amplitude) const {
  const double position = amplitude * scale_;
  const auto panel = std::min(static_cast<std::size_t>(position), panels_.size() - 1);
  return chebyshev_interpolant(panels_[panel], position - static_cast<double>(panel));
}

void LinearCharacteristicFunction::tabulate() {
  constexpr int kMaxPanels = 32;
  constexpr double kLogNegligible = -40;  // exp(-40) = 4e-18
  std::vector<Panel> panels;
  do {
    Panel& panel = panels.emplace_back();
    for (int n = 0; n <= kPanelOrder; ++n) {
      const double position =
          static_cast<double>(panels.size() - 1) + chebyshev_point(n, kPanelOrder);
      panel[n] = integrate_from_zero(position / scale_, 0);
    }
  } while (panels.size() < kMaxPanels && panels.back().back() > kLogNegligible);
  panels_ = std::move(panels);
}

}  // namespace fpkcheck::exact
