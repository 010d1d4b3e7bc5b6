#include "mcs/impulses/uniform_numbers.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::mcs {
namespace {

// Known-answer tests of Philox4x32-10 from Random123.
TEST(RandomBits, AreThoseOfPhilox) {
  const auto bits =
      random_bits(0xffffffffffffffffull, 0xffffffffu, static_cast<RandomNumberPurpose>(0xffffffffu),
                  0xffffffffffffffffull);
  EXPECT_EQ(bits, (std::array<std::uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(random_bits(0, 0, RandomNumberPurpose::impulses, 0),
            (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(UniformNumbers, LieWithinZeroAndOneAndGoOnFromAnyNumber) {
  const UniformNumbers all = uniform_numbers(3, 7, RandomNumberPurpose::start, 0),
                       later = uniform_numbers(3, 7, RandomNumberPurpose::start, 4);
  for (std::size_t k = 0; k < kBlockSize; ++k) {
    for (const double u : {all.first[k], all.second[k], all.third[k]}) {
      EXPECT_GT(u, 0);
      EXPECT_LT(u, 1);
    }
    if (k < 4) continue;
    EXPECT_EQ(all.first[k], later.first[k - 4]);
    EXPECT_EQ(all.second[k], later.second[k - 4]);
    EXPECT_EQ(all.third[k], later.third[k - 4]);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
