#include "methods/side_by_side.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace fpkcheck::methods {
namespace {

TEST(SideBySide, DoesEachWorkOnce) {
  for (const int threads : {0, 1, 3, 50}) {
    std::vector<std::atomic<int>> done(20);
    side_by_side(done.size(), threads, [&](std::size_t k) { ++done[k]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
  side_by_side(0, 2, [](std::size_t) { FAIL(); });
}

TEST(SideBySide, EndsWithTheFirstExceptionAndBeginsNoMore) {
  std::atomic<int> begun = 0;
  const auto work = [&](std::size_t) {
    ++begun;
    throw std::runtime_error("no");
  };
  EXPECT_THROW(side_by_side(1000, 2, work), std::runtime_error);
  EXPECT_LE(begun, 2);
}

}  // namespace
}  // namespace fpkcheck::methods
