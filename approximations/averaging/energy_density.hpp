#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "problem/effective_potential.hpp"
#include "problem/energy_averaging.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::averaging {

/// The energy bands of EnergyAveraging, which have equal widths, ordered in levels of equal energy.
/// With several wells, a level has one band for each orbit of its energy.
class EnergyLevels {
 public:
  /// @param averaging energy averaging of confined motion
  explicit EnergyLevels(std::shared_ptr<const problem::EnergyAveraging> averaging);

  using EnergyBand = problem::EnergyAveraging::EnergyBand;
  const std::vector<EnergyBand>& energy_bands() const { return averaging_->energy_bands(); }
  const problem::UndampedOrbits& undamped_orbits() const { return averaging_->undamped_orbits(); }
  const problem::EffectivePotential& effective_potential() const {
    return undamped_orbits().potential();
  }
  double energy_width_of_band() const { return width_; }
  /// Returns the density p(y, v) on the orbit at the middle of a band, if the probability of the
  /// band is 1 and the density decreases with the energy as under white noise of the same
  /// intensity.
  double density_of_band_with_unit_probability(std::size_t band) const;
  std::size_t level_count() const { return first_band_of_level_.size() - 1; }
  double energy_of_level(std::size_t level) const {
    return energy_bands()[first_band_of_level_[level]].energy;
  }
  /// Returns the index of the band of this level whose orbit contains the displacement y, or else
  /// the band whose orbit is nearest to y.
  std::size_t band_index_at(std::size_t level, double y) const;

 private:
  std::shared_ptr<const problem::EnergyAveraging> averaging_;
  std::vector<std::size_t> first_band_of_level_;  // with an additional end
  double width_;
};

/// Returns the joint density p(y, v) = exp(-Phi(h)), with h = v^2/2 + V(y), that has the given
/// probabilities of the energy bands. The exponent Phi is interpolated linearly between the
/// energies of the bands of one well.
transform::SmoothDensity joint_density(const EnergyLevels& levels,
                                       const std::vector<double>& band_probabilities);

}  // namespace fpkcheck::averaging
