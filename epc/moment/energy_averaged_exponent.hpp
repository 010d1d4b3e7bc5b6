#pragma once

#include <vector>

#include "problem/energy_averaging.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

/// Exponent -Phi(h) of the energy-averaged density (problem/energy_averaging.hpp) with the energy
/// h, as a function of y and v. At energies below a maximum of the potential, the exponent -Phi of
/// the energy-averaged density is a separate function in each potential well.
class EnergyAveragedExponent {
 public:
  /// @pre the problem is confined
  explicit EnergyAveragedExponent(const problem::Problem& problem);

  /// The exponent of the energy-averaged density is interpolated linearly in the energy between
  /// energy bands, and extrapolated beyond the last band.
  double operator()(double y, double v) const;

  double temperature() const { return temperature_; }
  /// Returns the smallest energy, relative to the minimum of the potential, above which the
  /// exponent -Phi of the energy-averaged density is below -`depth`.
  double energy_at_exponent_decrease(double depth) const;
  /// Energy below which 95 % of the probability of the energy-averaged density lies.
  double energy_of_95_percent_quantile() const { return bulk_; }
  /// Largest energy at which the potential has several wells; 0 for a potential with a single well.
  double barrier_energy() const { return barrier_; }

 private:
  using Band = problem::EnergyAveraging::EnergyBand;
  explicit EnergyAveragedExponent(const problem::EnergyAveraging& averaging);
  const Band& nearest_energy_band(double y, double energy) const;
  double exponent_slope_above_energy_band(const Band& band) const;

  problem::EffectivePotential potential_;
  double bottom_;  // minimum of the potential
  std::vector<Band> bands_;
  std::vector<std::size_t> levels_;  // index of the first band of each energy, then the end
  double step_;                      // difference of successive energies of the bands
  double temperature_ = 0, bulk_ = 0, barrier_ = 0;
};

}  // namespace fpkcheck::epc::moment
