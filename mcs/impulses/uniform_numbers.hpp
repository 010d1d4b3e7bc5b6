#pragma once

#include <array>
#include <cstdint>

namespace fpkcheck::mcs {

/// Purpose of random numbers; different purposes use different counters of the generator.
enum class RandomNumberPurpose : std::uint32_t { impulses, start, noise };

/// Returns 128 random bits as a function of (seed, stream, purpose, number), by the counter-based
/// generator Philox4x32-10 (Salmon et al., SC 2011, Random123).
std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint32_t stream,
                                         RandomNumberPurpose purpose, std::uint64_t number);

inline constexpr int kImpulsesPerBlock = 16;

/// Uniform random numbers in (0, 1) for a block of impulses: three numbers of 53, 43 and 32 bits
/// for each impulse. The 43 bits of the second number limit the amplitude to 7.8 standard
/// deviations of a Gaussian law and to 30 scales of a Laplace law.
struct UniformRandomNumbers {
  std::array<double, kImpulsesPerBlock> first, second, third;
};

/// Returns the uniform random numbers of kImpulsesPerBlock successive impulses of a trajectory
/// stream, beginning with the impulse `first_impulse`.
UniformRandomNumbers uniform_random_numbers(std::uint64_t seed, std::uint32_t stream,
                                            RandomNumberPurpose purpose,
                                            std::uint64_t first_impulse);

}  // namespace fpkcheck::mcs
