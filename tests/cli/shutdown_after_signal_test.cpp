#include "cli/shutdown_after_signal.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "base/process/stop_request.hpp"

namespace fpkcheck::cli {
namespace {

// The command ends by itself at the moment at which the watchdog claims the shutdown. An earlier
// version deadlocked here, about once in some hundred signals.
[[noreturn]] void end_at_the_grace_period() {
  alarm(20);
  base::request_stop(SIGINT);
  {
    const ShutdownWatchdog watchdog;
    notify_watchdog();
    claim_shutdown_for_this_thread();
    std::this_thread::sleep_for(std::chrono::seconds(1));  // the grace is 0.3
  }
  std::_Exit(7);
}

TEST(Shutdown, DoesNotDeadlockWithACommandThatEndsByItself) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(end_at_the_grace_period(), testing::ExitedWithCode(7), "");
}

TEST(Shutdown, EndsACommandThatDoesNotEnd) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        alarm(20);
        base::request_stop(SIGTERM);
        const ShutdownWatchdog watchdog;
        notify_watchdog();
        while (true) pause();
      },
      testing::ExitedWithCode(128 + SIGTERM), "terminated; nothing was written");
}

}  // namespace
}  // namespace fpkcheck::cli
