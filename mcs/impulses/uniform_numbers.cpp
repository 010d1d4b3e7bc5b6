#include "mcs/impulses/uniform_numbers.hpp"

#include <Random123/philox.h>

namespace fpkcheck::mcs {

std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint32_t stream,
                                         RandomNumberPurpose purpose, std::uint64_t number) {
  const r123::Philox4x32 philox;
  const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(number),
                                            static_cast<std::uint32_t>(number >> 32), stream,
                                            static_cast<std::uint32_t>(purpose)}};
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const auto bits = philox(counter, key);
  return {bits[0], bits[1], bits[2], bits[3]};
}

UniformRandomNumbers uniform_random_numbers(std::uint64_t seed, std::uint32_t stream,
                                            RandomNumberPurpose purpose,
                                            std::uint64_t first_impulse) {
  UniformRandomNumbers u;
  for (std::uint64_t k = 0; k < kImpulsesPerBlock; ++k) {
    const auto bits = random_bits(seed, stream, purpose, first_impulse + k);
    const std::uint64_t word = std::uint64_t{bits[0]} << 32 | bits[1];
    const std::uint64_t rest = std::uint64_t{bits[2]} << 11 | (word & 0x7ff);
    u.first[k] = (static_cast<double>(word >> 11) + 0.5) * 0x1p-53;
    u.second[k] = (static_cast<double>(rest) + 0.5) * 0x1p-43;
    u.third[k] = (static_cast<double>(bits[3]) + 0.5) * 0x1p-32;
  }
  return u;
}

}  // namespace fpkcheck::mcs
