#pragma once

#include <cstdint>
#include <vector>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/motion/taylor_flight.hpp"
#include "problem/energy_averaging.hpp"

namespace fpkcheck::mcs {

/// Returns the initial state of a trajectory stream: two independent Gaussian numbers z and z' with
/// mean 0, folded by paper (5), y = |z|, y' = z' sgn z.
OscillatorState folded_initial_state(const ImpulseSource& source, double displacement_deviation,
                                     double velocity_deviation);

/// Draws independent initial states from the energy-averaged density (problem::EnergyAveraging),
/// with the correct probability of each potential well and of each energy band. After
/// energy-averaged initial states the burn-in must remove only transients of the fast motion and
/// the error of energy averaging.
class InitialStateSampler {
 public:
  explicit InitialStateSampler(const problem::Problem& problem);

  OscillatorState operator()(std::uint64_t seed, std::uint32_t stream) const;

 private:
  problem::EnergyAveraging averaging_;
  std::vector<double> below_;  // cumulative masses of the energy bands
};

}  // namespace fpkcheck::mcs
