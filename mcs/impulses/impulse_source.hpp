#pragma once

#include <array>
#include <cstdint>

#include "mcs/impulses/excitation.hpp"
#include "mcs/impulses/uniform_numbers.hpp"

namespace fpkcheck::mcs {

/// A block of consecutive impulses: waiting times and amplitudes.
struct ImpulseBlock {
  std::array<double, kBlockSize> waiting{}, amplitude{};
};

// Makes a block of impulses from random numbers. One function, compiled for three instruction sets.
namespace baseline {
ImpulseBlock make_impulse_block(const Excitation& excitation, const UniformNumbers& uniforms);
}
namespace avx2 {
ImpulseBlock make_impulse_block(const Excitation& excitation, const UniformNumbers& uniforms);
}
namespace avx512 {
ImpulseBlock make_impulse_block(const Excitation& excitation, const UniformNumbers& uniforms);
}

/// One impulse of paper (3): waiting time after the previous impulse, and amplitude Y.
struct Impulse {
  double waiting;
  double amplitude;
};

/// Generator of the impulses of one stream. Impulse n is a function of (seed, stream, n) alone.
/// SIMD lanes draw the impulses in blocks.
class ImpulseSource {
 public:
  ImpulseSource(const Excitation& excitation, std::uint64_t seed, std::uint32_t stream,
                RandomNumberPurpose purpose = RandomNumberPurpose::impulses)
      : excitation_(excitation), seed_(seed), stream_(stream), purpose_(purpose) {}
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
  RandomNumberPurpose purpose_;
  std::uint64_t number_ = 0;
  ImpulseBlock block_{};
};

/// Generator of the standard normal random numbers of one stream, for Gaussian noise: the amplitudes
/// of standard_normal_impulses().
class NoiseSource {
 public:
  NoiseSource(std::uint64_t seed, std::uint32_t stream)
      : impulses_(standard_normal_impulses(), seed, stream, RandomNumberPurpose::noise) {}

  double next_normal() { return impulses_.next_impulse().amplitude; }

  /// How many normal numbers have been drawn so far.
  std::uint64_t number() const { return impulses_.number(); }
  /// Continues as if `number` normal numbers had been drawn.
  void continue_from(std::uint64_t number) { impulses_.continue_from(number); }

 private:
  ImpulseSource impulses_;
};

}  // namespace fpkcheck::mcs
