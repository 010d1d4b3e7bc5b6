#pragma once

#include <vector>

#include "problem/energy_averaging.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

/// The exponent -Phi(h) of the density that energy averaging gives (problem/energy_averaging.hpp),
/// as a function of y and v: in a well below the barrier that well's own.
class AveragedExponent {
 public:
  /// @pre the problem is confined
  explicit AveragedExponent(const problem::Problem& problem);

  /// Linear in the energy between the bands, and beyond them.
  double operator()(double y, double v) const;

  /// E[v^2].
  double temperature() const { return temperature_; }
  /// Energies, as EnergyDomain counts them: the least one above which Phi is larger than a depth,
  double energy_at(double depth) const;
  /// the one below which nearly all of the density lies,
  double bulk() const { return bulk_; }
  /// and the highest at which the motion has several wells to be in; 0 where it has one.
  double barrier() const { return barrier_; }

 private:
  using Band = problem::EnergyAveraging::Band;
  explicit AveragedExponent(const problem::EnergyAveraging& averaging);
  const Band& holding(double y, double energy) const;
  double slope_above(const Band& band) const;

  numerics::Polynomial potential_;
  double bottom_;  // min V
  std::vector<Band> bands_;
  std::vector<std::size_t> levels_;  // the first band of each energy, and the end
  double step_;                      // between energies
  double temperature_ = 0, bulk_ = 0, barrier_ = 0;
};

}  // namespace fpkcheck::epc::moment
