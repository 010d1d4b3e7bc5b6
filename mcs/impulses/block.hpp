#pragma once

#include <array>

#include "mcs/impulses/excitation.hpp"
#include "mcs/impulses/uniforms.hpp"

namespace fpkcheck::mcs {

/// Impulses that follow one another: how long after the one before each comes, and its amplitude.
struct Block {
  std::array<double, kBlock> waiting{}, amplitude{};
};

// A block of impulses made of random numbers: the same function, compiled for different
// instructions.
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
