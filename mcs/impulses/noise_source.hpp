#pragma once

#include <cstdint>

#include "mcs/impulses/block.hpp"

namespace fpkcheck::mcs {

/// Standard normal numbers of one stream, for Gaussian noise: number n is a function of (seed, stream,
/// n) alone. Made in blocks, in lanes.
class NoiseSource {
 public:
  NoiseSource(std::uint64_t seed, std::uint32_t stream) : seed_(seed), stream_(stream) {}

  double next() {
    const auto place = static_cast<std::size_t>(number_ % kBlock);
    if (place == 0) make_block();
    ++number_;
    return block_.amplitude[place];
  }

  /// How many have been given out.
  std::uint64_t number() const { return number_; }
  /// Continues as if `number` had been given out.
  void continue_from(std::uint64_t number);

 private:
  void make_block();

  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t number_ = 0;
  Block block_{};
};

}  // namespace fpkcheck::mcs
