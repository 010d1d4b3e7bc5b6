#include "epc/amplitude/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "epc/form/allowed.hpp"
#include "epc/half_plane/search.hpp"

namespace fpkcheck::epc::amplitude {

using Eigen::VectorXd;
using half_plane::Confinement;
using half_plane::Points;
using half_plane::QuadratureSize;
using half_plane::Refinement;
using half_plane::Shape;
using half_plane::Stage;

namespace {

// Depths of Q_n below its peak at the confinement level, in the order of the attempts.
constexpr std::array kDepths{24.0, 18.0, 32.0};
// Further candidates for the confinement level, as amplitudes: multiples of the decay extent, if
// Q_n rises again, and multiples of the deviation of v.
constexpr std::array kBeyondTrusted{1.2, 1.0};
constexpr std::array kLevelDeviations{8.0, 6.5, 11.0};
constexpr double kFarthestDeviations = 30;
// Largest density at the confinement level, relative to the peak. With more, the confinement would
// determine the density.
constexpr double kLevelAllowed = 1e-4;

double farthest(double temperature) { return kFarthestDeviations * std::sqrt(temperature); }

}  // namespace

double exponent_on_the_way(const Exponent& q, const Shape& shape, double rho, double theta) {
  const double inside = std::min(rho, shape.trusted);
  return q(inside, theta) - (rho * rho - inside * inside) / (2 * shape.temperature);
}

Shape Setting::start() const {
  Shape shape{.q = Polynomial({{2, 0, -1 / (2 * temperature_)}}), .temperature = temperature_};
  shape.trusted = trusted(shape.q, temperature_);
  return shape;
}

std::vector<double> Setting::levels(const Shape& guess, Stage) const {
  const double end = farthest(guess.temperature);
  std::vector<double> levels;
  const auto add = [&](double rho) { levels.push_back(energy_at(rho)); };
  for (const double depth : kDepths) {
    const Fall fall = fall_of(on_circle(guess.q), depth, end);
    if (fall.reached) add(*fall.reached);
  }
  if (guess.trusted < end) {
    for (const double factor : kBeyondTrusted) add(factor * guess.trusted);
  }
  for (const double deviations : kLevelDeviations) add(deviations * std::sqrt(guess.temperature));
  return levels;
}

// The number of points grows with the width of the domain.
QuadratureSize Setting::size(int order, double level_in_temperatures, Stage stage) const {
  const int least = stage == Stage::rough ? 16 : 20;
  const double width = std::max(1.0, std::sqrt(2 * level_in_temperatures) / kLevelDeviations[0]);
  const int rho = static_cast<int>((least + 2 * order) * width);
  return {rho, least + 2 * order, rho};
}

Refinement Setting::refinement() const { return {Refinement::Rule::solved, 1e-5}; }

double Setting::exponent(const Shape& guess, double s, double t) const {
  return exponent_on_the_way(on_circle(guess.q), guess, s, phase(s, t));
}

double Setting::trusted(const Polynomial& q, double temperature) const {
  return fall_of(on_circle(q), kDepths.back(), farthest(temperature)).turning;
}

// A smaller power also weighs points beyond the decay extent: otherwise the fit would return Q_n.
VectorXd Setting::fit_weights(const Shape& guess, double support, const Points& points,
                              const VectorXd& exponent, const VectorXd&) const {
  constexpr double kFlatter = 0.5;
  const double power = amplitude_at(support) > guess.trusted ? kFlatter : 1;
  const VectorXd mass =
      points.weight.array() * (power * (exponent.array() - exponent.maxCoeff())).exp();
  return mass / mass.sum();
}

// Largest density between the confinement level and the edge of the support.
double Setting::remains(const Shape& found, Stage) const {
  constexpr int kInside = 50, kOutside = 12;
  const Confinement confinement = half_plane::confinement_of(found.level, tail_);
  const Exponent q = on_circle(found.q);
  const double rho = amplitude_at(found.level), end = amplitude_at(found.support);
  double peak = largest_at(q, 0), outside = -std::numeric_limits<double>::infinity();
  for (int i = 1; i <= kInside; ++i) peak = std::max(peak, largest_at(q, rho * i / kInside));
  for (int i = 0; i <= kOutside; ++i) {
    const double at = rho + (end - rho) * i / kOutside;
    outside = std::max(outside, largest_at(q, at) + confinement(energy_at(at)));
  }
  return std::exp(outside - peak);
}

double Setting::remains_allowed(Stage) const { return 1e-6; }

std::string objection(const char* what, double at_level, double edge) {
  if (!(at_level < kLevelAllowed)) {
    return fmt::format("{} at or beyond the confinement level is {:.1e} of its peak (limit {:.0e})",
                       what, at_level, kLevelAllowed);
  }
  if (!(edge < kEdgeAllowed)) {
    return fmt::format("{} on the edge of its support is {:.1e} of its peak (limit {:.0e})", what,
                       edge, kEdgeAllowed);
  }
  return "";
}

}  // namespace fpkcheck::epc::amplitude
