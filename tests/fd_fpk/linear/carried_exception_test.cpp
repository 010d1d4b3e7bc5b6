#include "fd_fpk/linear/carried_exception.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fpkcheck::fd_fpk {
namespace {

TEST(CarriedException, PassesFlagsOnAndHasNothingToThrowThen) {
  CarriedException thrown;
  EXPECT_EQ(thrown.flag_of([] { return 3; }), 3);
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CarriedException, ThrowsOnTheOtherSideTheFirstAndOnce) {
  CarriedException thrown;
  const auto callback = [](int number) { return [number]() -> int { throw number; }; };
  EXPECT_EQ(thrown.flag_of(callback(1)), CarriedException::kUnrecoverable);
  EXPECT_EQ(thrown.flag_of(callback(2)), CarriedException::kUnrecoverable);
  try {
    thrown.rethrow();
    FAIL() << "nothing was thrown";
  } catch (int number) {
    EXPECT_EQ(number, 1);
  }
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CarriedException, IsTheVeryObjectThatWasThrown) {
  CarriedException thrown;
  const std::exception* inside = nullptr;
  thrown.flag_of([&]() -> int {
    try {
      throw std::out_of_range("here");
    } catch (const std::exception& error) {
      inside = &error;
      throw;
    }
  });
  try {
    thrown.rethrow();
  } catch (const std::out_of_range& outside) {
    EXPECT_EQ(&outside, inside);
    EXPECT_STREQ(outside.what(), "here");
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
