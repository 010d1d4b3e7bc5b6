#include "numerics/ode/sundials_handles.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <stdexcept>

namespace fpkcheck::numerics::sundials_owned {
namespace {

TEST(CallbackExceptionStore, ReturnsFlagsOfCallbacks) {
  CallbackExceptionStore thrown;
  EXPECT_EQ(thrown.call_and_store_exception([] { return 3; }), 3);
  EXPECT_NO_THROW(thrown.rethrow_stored_exception());
}

TEST(CallbackExceptionStore, RethrowsTheFirstExceptionOnce) {
  CallbackExceptionStore thrown;
  const auto callback = [](int number) { return [number]() -> int { throw number; }; };
  EXPECT_EQ(thrown.call_and_store_exception(callback(1)), CallbackExceptionStore::kUnrecoverable);
  EXPECT_EQ(thrown.call_and_store_exception(callback(2)), CallbackExceptionStore::kUnrecoverable);
  try {
    thrown.rethrow_stored_exception();
    FAIL() << "nothing was thrown";
  } catch (int number) {
    EXPECT_EQ(number, 1);
  }
  EXPECT_NO_THROW(thrown.rethrow_stored_exception());
}

TEST(CallbackExceptionStore, RethrowsTheSameObject) {
  CallbackExceptionStore thrown;
  const std::exception* inside = nullptr;
  thrown.call_and_store_exception([&]() -> int {
    try {
      throw std::out_of_range("here");
    } catch (const std::exception& error) {
      inside = &error;
      throw;
    }
  });
  try {
    thrown.rethrow_stored_exception();
  } catch (const std::out_of_range& outside) {
    EXPECT_EQ(&outside, inside);
    EXPECT_STREQ(outside.what(), "here");
  }
}

}  // namespace
}  // namespace fpkcheck::numerics::sundials_owned
