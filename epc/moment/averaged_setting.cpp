#include "epc/moment/averaged_setting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "epc/form/allowed.hpp"
#include "epc/half_plane/search.hpp"
#include "epc/moment/equations.hpp"
#include "epc/moment/level_density.hpp"
#include "epc/moment/tail.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::epc::moment {

using half_plane::QuadratureSize;
using half_plane::Shape;
using half_plane::Stage;

namespace {

// Candidates for the confinement level, in the order of the attempts: energies with Phi = d^2/2,
// which corresponds to d deviations of a Gaussian.
constexpr std::array kDeviations{6.5, 7.2, 5.2, 8.0};
constexpr double kFarthest = 8;  // largest energy of a scan, in units of the first level
// Lower limits of the level, in units of bulk_energy: the term (energy / level)^16 of the
// confinement is then 5e-4 and 4e-8 at bulk_energy.
constexpr double kAboveBulk = 1.6, kFarAboveBulk = 2.9;
constexpr double kAboveBarrier = 1.3;

double depth_of(double deviations) { return deviations * deviations / 2; }

// Relaxation rate D_eff / E[v^2]: the damping c of a linear oscillator, else the combined effect of
// damping and impacts. Lower limit: kRounding times the frequency, since rounding errors of the
// undamped motion would dominate smaller rates.
double rate_of(const problem::Problem& problem, double temperature) {
  constexpr double kRounding = 1e-4;
  return std::max(total_intensity(problem) / (2 * temperature),
                  kRounding * problem::scales(problem).frequency);
}

}  // namespace

AveragedSetting::AveragedSetting(const problem::Problem& problem, const Options& options,
                                 std::vector<double> rate_moment)
    : problem_(problem),
      tail_(options.tail),
      rate_moment_(std::move(rate_moment)),
      averaged_(problem),
      rate_unit_(rate_of(problem, averaged_.temperature())) {}

// The start has no Q_n: exponent() evaluates the averaged density instead.
Shape AveragedSetting::start() const { return {.temperature = averaged_.temperature()}; }

// Order 2, a Gaussian, approximates no ring and few densities with several wells.
int AveragedSetting::first_order(int order) const { return std::min(order, 4); }

std::vector<double> AveragedSetting::levels(const Shape& guess, Stage stage) const {
  const double least = std::max(kAboveBulk * averaged_.bulk(), kAboveBarrier * averaged_.barrier());
  const double warmer = std::clamp(guess.temperature / averaged_.temperature(), 0.5, 2.0);
  std::vector<double> levels;
  for (const double deviations : kDeviations) {
    levels.push_back(std::max(least, warmer * averaged_.energy_at(depth_of(deviations))));
  }
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (stage == Stage::last && !guess.q.terms().empty()) {
    if (const auto whole = whole_level(guess, levels.front())) {
      levels.insert(levels.begin(), *whole);
    }
  }
  return levels;
}

std::optional<double> AveragedSetting::further(const Shape&, const Shape& found) const {
  const auto whole = whole_level(found, found.level);
  return whole && *whole > kFurther * found.level ? whole : std::nullopt;
}

// Energy at which Q_n of a density lies kNegligibleDepth below its peak.
std::optional<double> AveragedSetting::whole_level(const Shape& shape, double from) const {
  const double begin = std::max(from, kFarAboveBulk * averaged_.bulk());
  return fall_of(shape.q, problem_, begin,
                 kFarthest * averaged_.energy_at(depth_of(kDeviations[0])), kWholeDepth)
      .reached;
}

QuadratureSize AveragedSetting::size(int order, double level_in_temperatures, Stage stage) const {
  const double width = std::max(1.0, std::sqrt(2 * level_in_temperatures) / kDeviations[0]);
  const int least = stage == Stage::rough ? 20 : 32;
  const auto widened = [&](int points) { return static_cast<int>(points * std::sqrt(width)); };
  return {widened(least + 8 + 2 * order), widened(least + 2 * order), widened(least + 2 * order)};
}

half_plane::Refinement AveragedSetting::refinement() const {
  return {half_plane::Refinement::Rule::estimated, 1e-9};
}

half_plane::Points AveragedSetting::points(double support, const QuadratureSize& size) const {
  return EnergyDomain(problem_, support).rule(size.s, size.t);
}

half_plane::Equations AveragedSetting::equations(double support,
                                                 const half_plane::Confinement& confinement,
                                                 half_plane::Basis basis, half_plane::Points points,
                                                 const QuadratureSize& size) const {
  return moment::equations(problem_, rate_moment_, EnergyDomain(problem_, support), confinement,
                           std::move(basis), std::move(points), size.wall);
}

double AveragedSetting::exponent(const Shape& guess, double y, double v) const {
  return guess.q.terms().empty() ? averaged_(y, v) : guess.q(y, v);
}

// Fit to the averaged density: a small power weighs large energies too, where Q_n might rise.
Eigen::VectorXd AveragedSetting::fit_weights(const Shape& guess, double,
                                             const half_plane::Points& points,
                                             const Eigen::VectorXd& exponent,
                                             const Eigen::VectorXd& mass) const {
  if (!guess.q.terms().empty()) return mass;
  constexpr double kFlatter = 1.0 / 3;
  const Eigen::VectorXd flat =
      points.weight.array() * (kFlatter * (exponent.array() - exponent.maxCoeff())).exp();
  return flat / flat.sum();
}

double AveragedSetting::remains(const Shape& found, Stage stage) const {
  const double at_level = level_density(found, problem_);
  if (stage == Stage::rough) return at_level;
  return std::max(edge_density(found, problem_, tail_),
                  at_level * (kEdgeAllowed / kLevelDensityWanted));
}

double AveragedSetting::remains_allowed(Stage stage) const {
  return stage == Stage::rough ? kLevelDensityOnTheWay : kEdgeAllowed;
}

}  // namespace fpkcheck::epc::moment
