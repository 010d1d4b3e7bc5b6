#include "mcs/simulation/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace fpkcheck::mcs {
namespace {

TEST(ParallelFor, DoEveryShareOnce) {
  for (const int threads : {1, 3, 20}) {
    std::vector<int> done(11);
    parallel_for(threads, done.size(), [&](std::size_t share) { ++done[share]; });
    EXPECT_EQ(done, std::vector<int>(11, 1));
  }
  parallel_for(2, 0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, BeginNothingAfterAFailureAndPassItOn) {
  for (const int threads : {1, 4}) {
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t) {
      ++begun;
      throw std::runtime_error("no");
    };
    EXPECT_THROW(parallel_for(threads, 1000, work), std::runtime_error);
    EXPECT_LE(begun, threads);
  }
}

TEST(ParallelFor, AreAsManyAsAskedFor) {
  EXPECT_EQ(number_of_threads(5), 5);
  EXPECT_GE(number_of_threads({}), 1);
}

}  // namespace
}  // namespace fpkcheck::mcs
