#pragma once

#include <cstdint>
#include <vector>

#include "mcs/motion/flight.hpp"
#include "problem/energy_averaging.hpp"

namespace fpkcheck::mcs {

/// Where streams begin: independent draws of the averaged law (problem::EnergyAveraging), each well and
/// each ring with its mass. Only of the fast motion, and of what averaging misses, is there something
/// left for the burn-in to forget.
class GeneralStart {
 public:
  explicit GeneralStart(const problem::Problem& problem);

  /// Always the same one of a stream.
  State operator()(std::uint64_t seed, std::uint32_t stream) const;

 private:
  problem::EnergyAveraging averaging_;
  std::vector<double> below_;  // masses of the bands up to each, itself included
};

}  // namespace fpkcheck::mcs
