#include "exact/linear_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "exact/decaying_wave.hpp"
#include "exact/law_transforms.hpp"

namespace fpkcheck::exact {
namespace {

using std::numbers::pi;

constexpr double kMaxWaves = 5e4;  // a few seconds

// An x with P(|u1 z + u2 z'| > x) <= probability, by Chernoff's bound for a symmetric law. The
// bound holds for every theta > 0; the search minimises it:
//
//     x = ( lambda int_0^inf [ E[exp(theta a(t) Y)] - 1 ] dt - log(probability / 2) ) / theta,
//     a = u1 h + u2 h'.
double range(const problem::Problem& problem, double u1, double u2, double probability) {
  const auto& law = problem.impulses.amplitude_law();
  const double deviation = std::sqrt(mean_square_velocity(problem)) * std::hypot(u1, u2);
  double smallest = HUGE_VAL;
  for (double theta = 1 / deviation;; theta *= 1.02) {
    const DecayingWave wave = impulse_response(problem.system, theta * u1, theta * u2);
    if (!std::isfinite(moment_generating_function(law, wave.peak()))) return smallest;
    const auto excess = [&](double a) { return moment_generating_function(law, a) - 1; };
    const double exponent =
        problem.impulses.arrival_rate() *
        integrate_along_wave(wave, excess, law.amplitude_standard_deviation(), HUGE_VAL);
    const double bound = (exponent - std::log(probability / 2)) / theta;
    if (bound > smallest) return smallest;
    smallest = bound;
  }
}

// A radius beyond which phi is below the cut-off; at most 5 % above the smallest such radius.
double cutoff_radius(const LinearCharacteristicFunction& phi, double cutoff, double start,
                     double largest) {
  for (double radius = start; radius < largest; radius *= 1.05) {
    if (phi.max_beyond(radius) < cutoff) return radius;
  }
  throw InputError(fmt::format(
      "cut-off {}: the characteristic function is {:.1g} at the limit of {:.0f} waves; use a "
      "larger cut-off or more frequent impulses",
      cutoff, phi.max_beyond(largest), kMaxWaves));
}

void require_edges(std::span<const double> edges, const char* variable, double least) {
  const bool increase =
      std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>()) == edges.end() &&
      std::all_of(edges.begin(), edges.end(), [](double x) { return std::isfinite(x); });
  if (edges.size() < 2 || !increase || edges.front() < least) {
    throw InputError(fmt::format("edges of {} bins (must be two or more increasing numbers{})",
                                 variable, least == 0 ? ", none negative" : ""));
  }
}

// Averages over bins of cos(n pi x / range) and sin(n pi x / range) on -range .. range and 0
// outside, of shape (bins, count).
struct WaveAverages {
  Eigen::MatrixXd cosine, sine;
};

WaveAverages wave_averages(std::span<const double> edges, double range, int count) {
  const auto bins = static_cast<Eigen::Index>(edges.size()) - 1;
  WaveAverages averages{Eigen::MatrixXd(bins, count), Eigen::MatrixXd(bins, count)};
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const double from = std::clamp(edges[bin], -range, range);
    const double to = std::clamp(edges[bin + 1], -range, range);
    const double inside = (to - from) / (edges[bin + 1] - edges[bin]);
    for (int n = 0; n < count; ++n) {
      const double u = n * pi / range;
      const double factor = inside * boost::math::sinc_pi(u * (to - from) / 2);
      averages.cosine(bin, n) = factor * std::cos(u * (from + to) / 2);
      averages.sine(bin, n) = factor * std::sin(u * (from + to) / 2);
    }
  }
  return averages;
}

std::vector<double> to_row_major(const Eigen::MatrixXd& matrix) {
  std::vector<double> values(static_cast<std::size_t>(matrix.size()));
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), matrix.rows(), matrix.cols()) = matrix;
  return values;
}

}  // namespace

LinearDensity::LinearDensity(const problem::Problem& problem, double cutoff) : phi_(problem) {
  if (!(cutoff > 0 && cutoff < 1)) {
    throw InputError(fmt::format("cut-off {} (must lie between 0 and 1)", cutoff));
  }
  const double decay = 2 * problem.impulses.arrival_rate() / problem.system.damping();
  if (decay <= 2) {
    throw InputError(
        fmt::format("impulse.rate = {} (must be above system.damping = {}: the density is infinite "
                    "at rest)",
                    problem.impulses.arrival_rate(), problem.system.damping()));
  }
  z_.range = range(problem, 1, 0, cutoff);
  v_.range = range(problem, 0, 1, cutoff);

  // The largest u1 and u2 on the ellipse radius(u1, u2) = R are sqrt(k) R and R.
  const double frequency = std::sqrt(problem.system.stiffness());
  const double waves_per_square = frequency * z_.range * v_.range / (pi * pi);
  const double largest = std::sqrt(kMaxWaves / waves_per_square);
  const double start = 1 / std::sqrt(mean_square_velocity(problem));
  const double radius = cutoff_radius(phi_, cutoff, start, largest);
  z_.count = static_cast<int>(frequency * radius * z_.range / pi) + 1;
  v_.count = static_cast<int>(radius * v_.range / pi) + 1;
  const double damped = std::sqrt(problem.system.stiffness() -
                                  problem.system.damping() * problem.system.damping() / 4);
  // The integral 2 / (4 pi^2) int_{R > R0} cutoff (R0 / R)^decay w R dR d(phase).
  joint_truncation_ = cutoff * damped * radius * radius / (pi * (decay - 2));

  even_.setZero(z_.count, v_.count);
  odd_.setZero(z_.count, v_.count);
  const auto wave = [&](double u1, double u2) {
    return phi_.radius(u1, u2) < radius ? phi_(u1, u2) : 0;
  };
  // p_Z = 1 / (4 Z V) sum of phi cos(u_n z + w_m v) over all n, m. The loops run over n, m >= 0,
  // and p = 2 p_Z.
  const double weight = 2 / (4 * z_.range * v_.range);
  for (int n = 0; n < z_.count; ++n) {
    for (int m = 0; m < v_.count; ++m) {
      const double u1 = n * pi / z_.range, u2 = m * pi / v_.range;
      const double same_signs = wave(u1, u2);
      const double other_signs = n == 0 || m == 0 ? same_signs : wave(u1, -u2);
      const double copies = 2 * weight * (n == 0 ? 0.5 : 1) * (m == 0 ? 0.5 : 1);
      even_(n, m) = copies * (same_signs + other_signs);
      odd_(n, m) = copies * (same_signs - other_signs);
    }
  }
}

Eigen::MatrixXd LinearDensity::averages(const Eigen::MatrixXd& even_y, const Eigen::MatrixXd& odd_y,
                                        std::span<const double> v_edges) const {
  const auto v = wave_averages(v_edges, v_.range, v_.count);
  return (even_y * even_) * v.cosine.transpose() - (odd_y * odd_) * v.sine.transpose();
}

std::vector<double> LinearDensity::displacement_averages(std::span<const double> edges) const {
  require_edges(edges, "y", 0);
  // In the integral over all v only the waves with u2 = 0 remain.
  return to_row_major(wave_averages(edges, z_.range, z_.count).cosine * even_.col(0) *
                      (2 * v_.range));
}

std::vector<double> LinearDensity::velocity_averages(std::span<const double> edges) const {
  require_edges(edges, "y'", -HUGE_VAL);
  const std::array half_plane{0.0, z_.range};
  const auto y = wave_averages(half_plane, z_.range, z_.count);
  return to_row_major(averages(y.cosine, y.sine, edges) * z_.range);
}

std::vector<double> LinearDensity::joint_averages(std::span<const double> y_edges,
                                                  std::span<const double> v_edges) const {
  require_edges(y_edges, "y", 0);
  require_edges(v_edges, "y'", -HUGE_VAL);
  const auto y = wave_averages(y_edges, z_.range, z_.count);
  return to_row_major(averages(y.cosine, y.sine, v_edges));
}

}  // namespace fpkcheck::exact
