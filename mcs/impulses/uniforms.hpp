#pragma once

#include <array>
#include <cstdint>

namespace fpkcheck::mcs {

/// Use of random numbers. Numbers of different purposes never coincide.
enum class Purpose : std::uint32_t { impulses, start, noise };

/// 128 random bits as a function of (seed, stream, purpose, number): Philox4x32-10 (Salmon et al.,
/// SC 2011, Random123). The function has no state, so the order of calls does not matter.
std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint32_t stream, Purpose purpose,
                                         std::uint64_t number);

/// Number of impulses per block.
inline constexpr int kBlockSize = 16;

/// Numbers in (0, 1) for a block of impulses. The 128 bits of one counter give numbers of 53, 43
/// and 32 bits. The second number limits the amplitude: 7.8 deviations of a Gaussian, 30 scales of
/// a Laplace law.
struct Uniforms {
  std::array<double, kBlockSize> first, second, third;
};

/// The numbers `from` .. `from + kBlockSize - 1` of a stream.
Uniforms uniforms(std::uint64_t seed, std::uint32_t stream, Purpose purpose, std::uint64_t from);

}  // namespace fpkcheck::mcs
