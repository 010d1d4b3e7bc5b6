#include "approximations/averaging/energy_density.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace fpkcheck::averaging {

EnergyLevels::EnergyLevels(std::shared_ptr<const problem::EnergyAveraging> averaging)
    : averaging_(std::move(averaging)) {
  const auto& bands = energy_bands();
  for (std::size_t b = 0; b < bands.size(); ++b) {
    if (b == 0 || bands[b].energy != bands[b - 1].energy) first_band_of_level_.push_back(b);
  }
  first_band_of_level_.push_back(bands.size());
  assert(level_count() > 1);
  width_ = energy_of_level(1) - energy_of_level(0);
}

// The mean of exp(-slope h) over a band is sinh(x) / x times the value at the middle, with
// x = slope dh / 2. The area of the band in the phase plane is T dh.
double EnergyLevels::density_of_band_with_unit_probability(std::size_t band) const {
  const auto& orbit = energy_bands()[band].orbit;
  const double x = problem::energy_exponent_slope(orbit) * width_ / 2;
  return (x == 0 ? 1 : x / std::sinh(x)) / (orbit.period * width_);
}

std::size_t EnergyLevels::band_index_at(std::size_t level, double y) const {
  const auto distance_to_orbit = [&](std::size_t band) {
    const auto& [left, right, left_is_wall, right_is_wall] = energy_bands()[band].orbit.half_cycle;
    return std::max({left - y, y - right, 0.0});
  };
  std::size_t nearest = first_band_of_level_[level];
  for (std::size_t b = nearest + 1; b < first_band_of_level_[level + 1]; ++b) {
    if (distance_to_orbit(b) < distance_to_orbit(nearest)) nearest = b;
  }
  return nearest;
}

transform::SmoothDensity joint_density(const EnergyLevels& levels,
                                       const std::vector<double>& band_probabilities) {
  const auto& bands = levels.energy_bands();
  // The rounding errors of the probabilities may be negative.
  constexpr double kSmallest = 1e-300;
  std::vector<double> exponent(bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    exponent[b] = -std::log(std::max(
        band_probabilities[b] * levels.density_of_band_with_unit_probability(b), kSmallest));
  }
  double y_min = bands.front().orbit.half_cycle.left, y_max = bands.front().orbit.half_cycle.right;
  for (const auto& band : bands) {
    y_min = std::min(y_min, band.orbit.half_cycle.left);
    y_max = std::max(y_max, band.orbit.half_cycle.right);
  }
  const double lowest = levels.energy_of_level(0);
  const double top = levels.energy_of_level(levels.level_count() - 1);
  double lowest_potential = lowest;
  constexpr int kSamples = 1000;
  for (int k = 0; k <= kSamples; ++k) {
    lowest_potential = std::min(
        lowest_potential,
        levels.effective_potential()(std::lerp(y_min, y_max, static_cast<double>(k) / kSamples)));
  }
  const auto value = [levels, exponent, lowest, top](double y, double v) {
    const double energy = v * v / 2 + levels.effective_potential()(y);
    if (energy > top) return 0.0;
    const double position = (energy - lowest) / levels.energy_width_of_band();
    const auto lower_level =
        std::min(static_cast<std::size_t>(std::max(0.0, position)), levels.level_count() - 2);
    const std::size_t upper = levels.band_index_at(lower_level + 1, y);
    const std::size_t lower = levels.band_index_at(lower_level, y);
    const double fraction = position - static_cast<double>(lower_level);
    if (levels.energy_bands()[lower].parent == upper) {
      return std::exp(-std::lerp(exponent[lower], exponent[upper], fraction));
    }
    // The bottom of this well lies between the two levels: the exponent is extrapolated from the
    // two bands above.
    const std::size_t above = levels.energy_bands()[upper].parent;
    return std::exp(-std::lerp(exponent[upper], exponent[above], fraction - 1));
  };
  return {.value = value,
          .y_max = y_max,
          .v_max = std::sqrt(2 * (top - lowest_potential)),
          .y_min = y_min};
}

}  // namespace fpkcheck::averaging
