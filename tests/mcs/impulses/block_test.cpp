#include "mcs/impulses/impulse_source.hpp"

#include <gtest/gtest.h>

#include <string>

#include "laws.hpp"
#include "numerics/simd/instruction_set.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

TEST(ImpulseBlock, HasTheSameBitsForAnyInstructions) {
  for (const std::string& law : tests::law_names_without_table()) {
    const auto problem = tests::make_problem({.mean = 0.1, .law = law});
    for (const auto& excitation :
         {poisson_excitation(problem.impulses), white_noise_excitation(problem.impulses, 0.05)}) {
      const UniformNumbers u = uniform_numbers(1, 2, RandomNumberPurpose::impulses, 32);
      const ImpulseBlock expected = baseline::make_impulse_block(excitation, u);
      for (const simd::CodeVariant& lanes : simd::available_code_variants()) {
        const auto make =
            simd::select_variant(lanes.instructions, baseline::make_impulse_block,
                                 avx2::make_impulse_block, avx512::make_impulse_block);
        const ImpulseBlock block = make(excitation, u);
        EXPECT_EQ(block.waiting, expected.waiting) << law;
        EXPECT_EQ(block.amplitude, expected.amplitude) << law;
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
