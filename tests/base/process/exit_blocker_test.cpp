#include "base/process/stop_request.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace fpkcheck::base {
namespace {

using namespace std::chrono_literals;

// This test must be the last test of its executable: afterwards no other thread can construct a
// guard until the process ends.
TEST(ExitBlocker, DelaysReservationAndThenBlocksOthers) {
  std::atomic<bool> reserved = false;
  std::optional<ProcessExitBlocker> outer(std::in_place);
  std::optional<ProcessExitBlocker> inner(std::in_place);
  std::jthread ending([&] {
    wait_for_exit_blockers();
    reserved = true;
    reserved.notify_all();
    const ProcessExitBlocker own;  // the thread that ends the process may write
    reserved.wait(true);           // blocks as until the process ends
  });
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(reserved);
  inner.reset();
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(reserved);
  outer.reset();
  reserved.wait(false);

  static std::atomic<bool> late = false;
  std::thread([] {
    const ProcessExitBlocker too_late;
    late = true;
  }).detach();
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(late);
  reserved = false;
  reserved.notify_all();
}

}  // namespace
}  // namespace fpkcheck::base
