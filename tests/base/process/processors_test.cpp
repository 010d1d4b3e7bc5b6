#include "base/process/processors.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <thread>

namespace fpkcheck::base {
namespace {

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
