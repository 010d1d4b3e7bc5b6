#include "approximations/averaging/band_probabilities.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::averaging {
namespace {

using Eigen::Index;
using EnergyBand = EnergyLevels::EnergyBand;

// A point of an undamped orbit, with the fraction of the period that the point represents.
struct OrbitPoint {
  double y, speed, time_fraction;
};

// Returns points of an orbit, by the midpoint rule in the angle t with y = c - a cos(t). The
// integrand dy / v is a smooth function of t at a turning point and at a wall.
std::vector<OrbitPoint> orbit_points(const problem::EffectivePotential& potential,
                                     const problem::HalfCycle& half_cycle, double energy) {
  constexpr int kPoints = 32;
  const double centre = (half_cycle.left + half_cycle.right) / 2;
  const double half_length = (half_cycle.right - half_cycle.left) / 2;
  std::vector<OrbitPoint> points;
  double total = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / kPoints;
    const double y = centre - half_length * std::cos(angle);
    const double speed = std::sqrt(std::max(0.0, 2 * (energy - potential(y))));
    if (speed == 0) continue;
    points.push_back({y, speed, std::sin(angle) / speed});
    total += points.back().time_fraction;
  }
  for (OrbitPoint& point : points) point.time_fraction /= total;
  return points;
}

// Returns the orbit of an energy within a band; the orbit at the middle of the band if the band
// contains an energy at which orbits appear or separate.
std::pair<problem::HalfCycle, double> orbit_in_band(const problem::UndampedOrbits& orbits,
                                                    const EnergyBand& band, double energy) {
  const auto& [left, right, left_is_wall, right_is_wall] = band.orbit.half_cycle;
  const auto half_cycles = orbits.half_cycles(energy);
  if (half_cycles.size() == orbits.half_cycles(band.energy).size()) {
    for (const problem::HalfCycle& half_cycle : half_cycles) {
      const double middle = (half_cycle.left + half_cycle.right) / 2;
      if (left <= middle && middle <= right) return {half_cycle, energy};
    }
  }
  return {band.orbit.half_cycle, band.energy};
}

// Returns the states of a band from which impulses act: points of the orbits at the two Gauss
// points of the band, with weights exp(-slope (h - centre)) as in the density of white noise.
std::vector<OrbitPoint> band_points(const EnergyLevels& levels, const EnergyBand& band) {
  const double distance = levels.energy_width_of_band() / (2 * std::numbers::sqrt3);
  const double slope = problem::energy_exponent_slope(band.orbit);
  std::vector<OrbitPoint> points;
  double total = 0;
  for (const double shift : {-distance, distance}) {
    const auto [half_cycle, energy] =
        orbit_in_band(levels.undamped_orbits(), band, band.energy + shift);
    const double weight = std::exp(-slope * (energy - band.energy));
    total += weight;
    for (OrbitPoint point : orbit_points(levels.effective_potential(), half_cycle, energy)) {
      point.time_fraction *= weight;
      points.push_back(point);
    }
  }
  for (OrbitPoint& point : points) point.time_fraction /= total;
  return points;
}

// Adds the rates of the jumps from a band into all bands to a column of the generator.
void add_jump_rates(const problem::Problem& problem, const EnergyLevels& levels, std::size_t from,
                    Eigen::MatrixXd& generator) {
  const auto& law = problem.impulses.amplitude_law();
  const double rate = problem.impulses.arrival_rate();
  const double lowest = levels.energy_of_level(0), width = levels.energy_width_of_band();
  for (const OrbitPoint& point : band_points(levels, levels.energy_bands()[from])) {
    const double potential = levels.effective_potential()(point.y);
    const double factor = problem.impulse_factor ? (*problem.impulse_factor)(point.y, 0) : 1;
    if (factor == 0) continue;
    // Returns the probability of a velocity below w after the impulse, from the velocity v.
    const auto probability_below = [&](double w, double v) {
      const double below = law.cumulative_probability((w - v) / factor);
      return factor > 0 ? below : 1 - below;
    };
    // Returns the probability, over both signs of the velocity, of an energy after the impulse
    // below the upper edge of a level.
    const auto probability_up_to = [&](std::size_t level) {
      const double energy = lowest + (static_cast<double>(level) + 0.5) * width;
      if (energy <= potential) return 0.0;
      const double w = std::sqrt(2 * (energy - potential));
      double sum = 0;
      for (const double v : {point.speed, -point.speed}) {
        sum += (probability_below(w, v) - probability_below(-w, v)) / 2;
      }
      return sum;
    };
    // Levels outside of this range have a probability below the rounding unit.
    constexpr double kNegligible = 1e-16;
    std::size_t level = 0;
    for (std::size_t end = levels.level_count() - 1; level < end;) {
      const std::size_t middle = (level + end) / 2;
      if (probability_up_to(middle) < kNegligible) {
        level = middle + 1;
      } else {
        end = middle;
      }
    }
    const double weight = rate * point.time_fraction;
    double below = 0;
    for (; level < levels.level_count() && below < 1 - kNegligible; ++level) {
      const bool last = level + 1 == levels.level_count();
      const double up_to = last ? 1 : probability_up_to(level);
      const auto to = static_cast<Index>(levels.band_index_at(level, point.y));
      generator(to, static_cast<Index>(from)) += weight * (up_to - below);
      below = up_to;
    }
    generator(static_cast<Index>(from), static_cast<Index>(from)) -= weight * below;
  }
}

// Returns the closed integral of D G v dy over the orbit of a band.
double noise_diffusion_per_period(const problem::Problem& problem, const EnergyLevels& levels,
                                  const EnergyBand& band) {
  if (!problem.noise.is_acting()) return 0;
  double mean = 0;
  for (const OrbitPoint& point :
       orbit_points(levels.effective_potential(), band.orbit.half_cycle, band.energy)) {
    for (const double v : {point.speed, -point.speed}) {
      mean += point.time_fraction / 2 * v * v * noise_diffusion_coefficient(problem, point.y, v);
    }
  }
  return band.orbit.period * mean;
}

// Returns the bands below each band in the tree of orbits.
std::vector<std::vector<std::size_t>> children_of_bands(const std::vector<EnergyBand>& bands) {
  std::vector<std::vector<std::size_t>> children(bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (bands[b].parent != b) children[bands[b].parent].push_back(b);
  }
  return children;
}

}  // namespace

std::vector<double> stationary_band_probabilities(const problem::Problem& problem,
                                                  const EnergyLevels& levels) {
  const auto& bands = levels.energy_bands();
  const auto n = static_cast<Index>(bands.size());
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(n, n);
  if (problem.impulses.is_acting()) {
    for (std::size_t b = 0; b < bands.size(); ++b) add_jump_rates(problem, levels, b, generator);
  }

  // Flux of probability from each parent into its band: W rho + D v^2 d rho/dh with rho = q / T.
  // The values of rho between two bands follow from rho exp(slope h), which is constant in energy
  // if the excitation is white noise of the same intensity: by linear extrapolation from the two
  // bands from which the energy loss transports probability, and by differences for the noise.
  const double width = levels.energy_width_of_band();
  const auto children = children_of_bands(bands);
  std::vector<double> loss, total_diffusion, noise_diffusion;  // integrals over the orbits
  for (const EnergyBand& band : bands) {
    loss.push_back(band.orbit.loss);
    total_diffusion.push_back(band.orbit.diffusion);
    noise_diffusion.push_back(noise_diffusion_per_period(problem, levels, band));
  }
  for (std::size_t child = 0; child < bands.size(); ++child) {
    const std::size_t parent = bands[child].parent;
    if (parent == child) continue;
    // Returns an integral over the orbit at the energy between the band and its parent. If the
    // orbit of the parent separates into several orbits, each orbit has a share of the parent's
    // integral in proportion to its own integral.
    const auto at_edge = [&](const std::vector<double>& integral) {
      double sum = 0;
      for (const std::size_t sibling : children[parent]) sum += integral[sibling];
      if (children[parent].size() > 1 && sum == 0) return 0.0;
      const double share = children[parent].size() == 1 ? 1 : integral[child] / sum;
      return (integral[child] + share * integral[parent]) / 2;
    };
    const double edge = (bands[child].energy + bands[parent].energy) / 2;
    const double loss_at_edge = at_edge(loss), noise_at_edge = at_edge(noise_diffusion);
    const double slope = loss_at_edge / at_edge(total_diffusion);
    const auto add_flux = [&](std::size_t band, double coefficient) {
      const double flux = coefficient * levels.density_of_band_with_unit_probability(band) *
                          std::exp(slope * (bands[band].energy - edge));
      generator(static_cast<Index>(child), static_cast<Index>(band)) += flux;
      generator(static_cast<Index>(parent), static_cast<Index>(band)) -= flux;
    };
    const std::size_t source = loss_at_edge > 0 ? parent : child;
    const std::size_t beyond = loss_at_edge > 0              ? bands[parent].parent
                               : children[child].size() == 1 ? children[child].front()
                                                             : child;
    add_flux(source, beyond == source ? loss_at_edge : 1.5 * loss_at_edge);
    if (beyond != source) add_flux(beyond, -loss_at_edge / 2);
    add_flux(child, noise_at_edge * (-1 / width - slope / 2));
    add_flux(parent, noise_at_edge * (1 / width - slope / 2));
  }

  // The columns of the generator have the sum 0: one equation is replaced by the sum 1.
  generator.row(0).setOnes();
  const Eigen::VectorXd probabilities =
      numerics::LuFactors(generator).solve(Eigen::VectorXd::Unit(n, 0));
  return {probabilities.begin(), probabilities.end()};
}

}  // namespace fpkcheck::averaging
