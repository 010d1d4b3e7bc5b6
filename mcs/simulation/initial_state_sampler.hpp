#pragma once

#include <cstdint>
#include <vector>

#include "mcs/motion/flight.hpp"
#include "problem/energy_averaging.hpp"

namespace fpkcheck::mcs {

/// Draws independent initial states from the energy-averaged law (problem::EnergyAveraging), which
/// has the correct mass of each well and of each energy band. The burn-in then only has to remove
/// transients of the fast motion and the error of the averaging.
class InitialStateSampler {
 public:
  explicit InitialStateSampler(const problem::Problem& problem);

  /// Initial state of a stream: a function of the seed and the number of the stream.
  State operator()(std::uint64_t seed, std::uint32_t stream) const;

 private:
  problem::EnergyAveraging averaging_;
  std::vector<double> below_;  // cumulative masses of the bands
};

}  // namespace fpkcheck::mcs
