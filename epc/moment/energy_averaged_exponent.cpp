#include "epc/moment/energy_averaged_exponent.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::epc::moment {

EnergyAveragedExponent::EnergyAveragedExponent(const problem::Problem& problem)
    : EnergyAveragedExponent(problem::EnergyAveraging(problem)) {}

EnergyAveragedExponent::EnergyAveragedExponent(const problem::EnergyAveraging& averaging)
    : potential_(averaging.undamped_orbits().potential()),
      bottom_(averaging.undamped_orbits().lowest_potential()),
      bands_(averaging.energy_bands()) {
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    if (b == 0 || bands_[b].energy != bands_[b - 1].energy) levels_.push_back(b);
  }
  levels_.push_back(bands_.size());
  step_ = (bands_.back().energy - bands_.front().energy) / static_cast<double>(levels_.size() - 2);

  constexpr double kBulk = 0.95;
  double below = 0;
  for (const Band& band : bands_) {
    // The action integral oint v dy of an orbit equals the period times the mean of v^2.
    temperature_ += band.mass * band.orbit.action / band.orbit.period;
    if (below < kBulk) bulk_ = band.energy - bottom_;
    below += band.mass;
  }
  for (std::size_t n = 0; n + 1 < levels_.size(); ++n) {
    if (levels_[n + 1] - levels_[n] > 1) barrier_ = bands_[levels_[n]].energy - bottom_ + step_;
  }
}

// If no orbit of the nearest tabulated energy contains the displacement y, the next energy is used.
const problem::EnergyAveraging::EnergyBand& EnergyAveragedExponent::nearest_energy_band(
    double y, double energy) const {
  const double place = std::round((energy - bands_.front().energy) / step_);
  const auto last = static_cast<double>(levels_.size() - 2);
  for (auto n = static_cast<std::size_t>(std::clamp(place, 0.0, last)); n + 1 < levels_.size();
       ++n) {
    for (std::size_t b = levels_[n]; b < levels_[n + 1]; ++b) {
      const problem::HalfCycle& half_cycle = bands_[b].orbit.half_cycle;
      if (y >= half_cycle.left && y <= half_cycle.right) return bands_[b];
    }
  }
  return bands_.back();
}

double EnergyAveragedExponent::exponent_slope_above_energy_band(const Band& band) const {
  const Band* lower = &band;
  const Band* upper = &bands_[band.parent];
  if (upper == lower) {
    const auto top = static_cast<std::size_t>(upper - bands_.data());
    for (const Band& other : bands_) {
      if (other.parent == top && &other != upper) lower = &other;
    }
  }
  return (upper->potential - lower->potential) / step_;
}

double EnergyAveragedExponent::operator()(double y, double v) const {
  const double energy = v * v / 2 + potential_(y);
  const Band& band = nearest_energy_band(y, energy);
  return -(band.potential + exponent_slope_above_energy_band(band) * (energy - band.energy));
}

double EnergyAveragedExponent::energy_at_exponent_decrease(double depth) const {
  const auto within = std::find_if(bands_.rbegin(), bands_.rend(),
                                   [depth](const Band& band) { return band.potential <= depth; });
  const Band& band = within == bands_.rend() ? bands_.front() : *within;
  const double slope = exponent_slope_above_energy_band(band);
  const double beyond = slope > 0 ? (depth - band.potential) / slope : 0;
  return band.energy - bottom_ + beyond;
}

}  // namespace fpkcheck::epc::moment
