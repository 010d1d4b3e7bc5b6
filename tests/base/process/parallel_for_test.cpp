#include "base/process/parallel_for.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <thread>
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
  EXPECT_EQ(resolve_thread_count(5), 5);
  EXPECT_GE(resolve_thread_count(0), 1);
}

class Processors : public ::testing::Test {
 protected:
  Processors() {
    unsetenv("SLURM_CPUS_PER_TASK");
    unsetenv("OMP_NUM_THREADS");
  }
  ~Processors() override {
    unsetenv("SLURM_CPUS_PER_TASK");
    unsetenv("OMP_NUM_THREADS");
  }
};

TEST_F(Processors, RespectAffinityMask) {
  int found = 0;
  std::thread([&] {  // affinity is a property of a thread
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    found = available_processors();
  })
      .join();
  EXPECT_EQ(found, 1);
  EXPECT_GE(available_processors(), 1);
}

TEST_F(Processors, RespectEnvironmentLimits) {
  const int own = available_processors();
  setenv("SLURM_CPUS_PER_TASK", "1", 1);
  EXPECT_EQ(available_processors(), 1);
  setenv("SLURM_CPUS_PER_TASK", "1000000", 1);
  EXPECT_EQ(available_processors(), own);
  setenv("OMP_NUM_THREADS", "1,4", 1);
  EXPECT_EQ(available_processors(), 1);
}

TEST_F(Processors, IgnoreInvalidEnvironmentValues) {
  const int own = available_processors();
  for (const char* nonsense : {"", "0", "-2", "many", "1.5", "99999999999999999999"}) {
    setenv("OMP_NUM_THREADS", nonsense, 1);
    EXPECT_EQ(available_processors(), own) << nonsense;
  }
}

}  // namespace
}  // namespace fpkcheck::base
