#pragma once

#include <cstdint>

#include "mcs/impulses/block.hpp"

namespace fpkcheck::mcs {

/// Generator of the standard normal random numbers of one stream, for Gaussian noise. Random number
/// n is a function of (seed, stream, n) alone. SIMD lanes draw the numbers in blocks.
class NoiseSource {
 public:
  NoiseSource(std::uint64_t seed, std::uint32_t stream) : seed_(seed), stream_(stream) {}

  double next_normal() {
    const auto index = static_cast<std::size_t>(number_ % kBlockSize);
    if (index == 0) make_impulse_block();
    ++number_;
    return block_.amplitude[index];
  }

  /// How many normal numbers have been drawn so far.
  std::uint64_t number() const { return number_; }
  /// Continues as if `number` normal numbers had been drawn.
  void continue_from(std::uint64_t number);

 private:
  void make_impulse_block();

  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t number_ = 0;
  ImpulseBlock block_{};
};

}  // namespace fpkcheck::mcs
