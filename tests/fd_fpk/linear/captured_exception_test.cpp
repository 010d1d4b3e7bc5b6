#include "fd_fpk/linear/captured_exception.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fpkcheck::fd_fpk {
namespace {

TEST(CapturedException, ReturnsFlagsOfCallbacks) {
  CapturedException thrown;
  EXPECT_EQ(thrown.invoke([] { return 3; }), 3);
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CapturedException, RethrowsTheFirstExceptionOnce) {
  CapturedException thrown;
  const auto callback = [](int number) { return [number]() -> int { throw number; }; };
  EXPECT_EQ(thrown.invoke(callback(1)), CapturedException::kUnrecoverable);
  EXPECT_EQ(thrown.invoke(callback(2)), CapturedException::kUnrecoverable);
  try {
    thrown.rethrow();
    FAIL() << "nothing was thrown";
  } catch (int number) {
    EXPECT_EQ(number, 1);
  }
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CapturedException, RethrowsTheSameObject) {
  CapturedException thrown;
  const std::exception* inside = nullptr;
  thrown.invoke([&]() -> int {
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
