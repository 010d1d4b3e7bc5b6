#include "base/process/files_in_hand.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace fpkcheck::base {
namespace {

// Never destroyed: a thread may still wait on it while the process exits.
struct Desk {
  std::mutex mutex;
  std::condition_variable changed;
  int hands = 0;
  std::thread::id only{};  // default id: no thread
};

Desk& desk() {
  static Desk& one = *new Desk;
  return one;
}

}  // namespace

FilesInHand::FilesInHand() {
  Desk& d = desk();
  std::unique_lock lock(d.mutex);
  d.changed.wait(
      lock, [&] { return d.only == std::thread::id() || d.only == std::this_thread::get_id(); });
  ++d.hands;
}

FilesInHand::~FilesInHand() {
  Desk& d = desk();
  const std::lock_guard lock(d.mutex);
  --d.hands;
  d.changed.notify_all();
}

void reserve_files_for_this_thread() {
  Desk& d = desk();
  std::unique_lock lock(d.mutex);
  d.changed.wait(lock, [&] { return d.hands == 0; });
  d.only = std::this_thread::get_id();
}

}  // namespace fpkcheck::base
