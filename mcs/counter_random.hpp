#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace fpkcheck::mcs {

/// What random numbers are for: numbers of different purposes never coincide.
enum class Purpose : std::uint32_t { impulses, start };

/// 128 random bits as a function of (seed, stream, purpose, number): Philox4x32-10 (Salmon et al.,
/// SC 2011, Random123). Nothing is remembered between calls, so that it does not matter who asks
/// for which number, or when.
inline std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint32_t stream,
                                                Purpose purpose, std::uint64_t number) {
  const r123::Philox4x32 philox;
  const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(number),
                                            static_cast<std::uint32_t>(number >> 32), stream,
                                            static_cast<std::uint32_t>(purpose)}};
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const auto bits = philox(counter, key);
  return {bits[0], bits[1], bits[2], bits[3]};
}

}  // namespace fpkcheck::mcs
