#pragma once

#include <array>

#include "mcs/impulses/excitation.hpp"
#include "mcs/impulses/uniforms.hpp"

namespace fpkcheck::mcs {

/// Consecutive impulses: waiting times and amplitudes.
struct Block {
  std::array<double, kBlock> waiting{}, amplitude{};
};

// Makes a block of impulses from random numbers. One function, compiled for three instruction sets.
namespace baseline {
Block make_block(const Excitation& excitation, const Uniforms& uniforms);
}
namespace avx2 {
Block make_block(const Excitation& excitation, const Uniforms& uniforms);
}
namespace avx512 {
Block make_block(const Excitation& excitation, const Uniforms& uniforms);
}

}  // namespace fpkcheck::mcs
