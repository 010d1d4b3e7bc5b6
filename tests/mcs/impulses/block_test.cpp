#include "mcs/impulses/block.hpp"

#include <gtest/gtest.h>

#include <string>

#include "laws.hpp"
#include "numerics/simd/instruction_set.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

TEST(Block, HasTheSameBitsForAnyInstructions) {
  for (const std::string& law : tests::laws_by_name()) {
    const auto problem = tests::make_problem({.mean = 0.1, .law = law});
    for (const auto& excitation :
         {poisson_excitation(problem.impulses), white_excitation(problem.impulses, 0.05)}) {
      const Uniforms u = uniforms(1, 2, Purpose::impulses, 32);
      const Block expected = baseline::make_block(excitation, u);
      for (const simd::LaneSet& lanes : simd::available_lanes()) {
        const auto make = simd::compiled_for(lanes.instructions, baseline::make_block,
                                             avx2::make_block, avx512::make_block);
        const Block block = make(excitation, u);
        EXPECT_EQ(block.waiting, expected.waiting) << law;
        EXPECT_EQ(block.amplitude, expected.amplitude) << law;
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
