#pragma once

#include <array>
#include <cstdint>

namespace fpkcheck::mcs {

/// What random numbers are for: numbers of different purposes never coincide.
enum class Purpose : std::uint32_t { impulses, start, noise };

/// 128 random bits as a function of (seed, stream, purpose, number): Philox4x32-10 (Salmon et al.,
/// SC 2011, Random123). Nothing is remembered between calls, so that it does not matter who asks
/// for which number, or when.
std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint32_t stream, Purpose purpose,
                                         std::uint64_t number);

/// Impulses are made in blocks of so many.
inline constexpr int kBlock = 16;

/// Numbers in (0, 1) for a block of impulses, made of the 128 bits of one counter each: of 53, 43
/// and 32 bits. The second one decides how far out an amplitude may lie: 7.8 deviations or 30
/// scales.
struct Uniforms {
  std::array<double, kBlock> first, second, third;
};

/// The numbers `from` .. `from + kBlock - 1` of a stream.
Uniforms uniforms(std::uint64_t seed, std::uint32_t stream, Purpose purpose, std::uint64_t from);

}  // namespace fpkcheck::mcs
