#pragma once

#include <cstdint>

#include "mcs/impulses/block.hpp"

namespace fpkcheck::mcs {

/// Standard normal numbers of one stream, for Gaussian noise. Number n is a function of (seed,
/// stream, n) alone. SIMD lanes make them in blocks.
class NoiseSource {
 public:
  NoiseSource(std::uint64_t seed, std::uint32_t stream) : seed_(seed), stream_(stream) {}

  double next() {
    const auto index = static_cast<std::size_t>(number_ % kBlockSize);
    if (index == 0) make_impulse_block();
    ++number_;
    return block_.amplitude[index];
  }

  /// Number of normal numbers drawn.
  std::uint64_t number() const { return number_; }
  /// Sets the number of normal numbers drawn.
  void continue_from(std::uint64_t number);

 private:
  void make_impulse_block();

  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t number_ = 0;
  ImpulseBlock block_{};
};

}  // namespace fpkcheck::mcs
