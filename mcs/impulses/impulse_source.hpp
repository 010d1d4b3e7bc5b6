#pragma once

#include <array>
#include <cstdint>

#include "mcs/impulses/block.hpp"
#include "mcs/impulses/excitation.hpp"

namespace fpkcheck::mcs {

/// One impulse of paper (3): waiting time after the previous impulse, and amplitude Y.
struct Impulse {
  double waiting;
  double amplitude;
};

/// Generator of the impulses of one stream. Impulse n is a function of (seed, stream, n) alone.
/// SIMD lanes draw the impulses in blocks.
class ImpulseSource {
 public:
  ImpulseSource(const Excitation& excitation, std::uint64_t seed, std::uint32_t stream)
      : excitation_(excitation), seed_(seed), stream_(stream) {}
  ImpulseSource(const problem::ImpulseTrain& impulses, std::uint64_t seed, std::uint32_t stream)
      : ImpulseSource(poisson_excitation(impulses), seed, stream) {}

  Impulse next_impulse() {
    const auto index = static_cast<std::size_t>(number_ % kBlockSize);
    if (index == 0) make_impulse_block();
    ++number_;
    return {block_.waiting[index], block_.amplitude[index]};
  }

  /// Number of impulses drawn so far.
  std::uint64_t number() const { return number_; }
  /// Continues after the impulse with this number, as if `number` impulses had been drawn.
  void continue_from(std::uint64_t number);

  /// Two independent standard normal numbers for the initial state of the stream. Every call
  /// returns the same numbers.
  std::array<double, 2> standard_normals() const;

 private:
  void make_impulse_block();

  Excitation excitation_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t number_ = 0;
  ImpulseBlock block_{};
};

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
