#pragma once

#include <array>

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

}  // namespace fpkcheck::mcs
