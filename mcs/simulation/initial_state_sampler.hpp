#pragma once

#include <cstdint>
#include <vector>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/motion/taylor_flight.hpp"
#include "problem/energy_averaging.hpp"

namespace fpkcheck::mcs {

/// Initial state of a stream: independent Gaussians z, z' of mean zero, folded by paper (5),
/// y = |z|, y' = z' sgn z.
State folded_initial_state(const ImpulseSource& source, double displacement_deviation,
                           double velocity_deviation);

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
