#include "fd_fpk/linear/callback_exception.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fpkcheck::fd_fpk {
namespace {

TEST(CallbackException, ReturnsFlagsOfCallbacks) {
  CallbackException thrown;
  EXPECT_EQ(thrown.invoke([] { return 3; }), 3);
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CallbackException, RethrowsTheFirstExceptionOnce) {
  CallbackException thrown;
  const auto callback = [](int number) { return [number]() -> int { throw number; }; };
  EXPECT_EQ(thrown.invoke(callback(1)), CallbackException::kUnrecoverable);
  EXPECT_EQ(thrown.invoke(callback(2)), CallbackException::kUnrecoverable);
  try {
    thrown.rethrow();
    FAIL() << "nothing was thrown";
  } catch (int number) {
    EXPECT_EQ(number, 1);
  }
  EXPECT_NO_THROW(thrown.rethrow());
}

TEST(CallbackException, RethrowsTheSameObject) {
  CallbackException thrown;
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
