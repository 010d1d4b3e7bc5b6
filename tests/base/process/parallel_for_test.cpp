#include "base/process/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace fpkcheck::base {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const int threads : {0, 1, 3, 50}) {
    std::vector<std::atomic<int>> done(20);
    parallel_for(done.size(), threads, [&](std::size_t k) { ++done[k]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
  parallel_for(0, 2, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsTheFirstException) {
  for (const int threads : {1, 4}) {
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t) {
      ++begun;
      throw std::runtime_error("no");
    };
    EXPECT_THROW(parallel_for(1000, threads, work), std::runtime_error);
    EXPECT_LE(begun, threads);
  }
}

TEST(ParallelFor, HasTheRequestedNumberOfThreads) {
  EXPECT_EQ(number_of_threads(5), 5);
  EXPECT_GE(number_of_threads(0), 1);
}

}  // namespace
}  // namespace fpkcheck::base
