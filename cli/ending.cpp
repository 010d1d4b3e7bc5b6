#include "cli/ending.hpp"

#include <fmt/format.h>
#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <exception>
#include <mutex>
#include <vector>

#include "base/process/stop.hpp"
#include "base/process/write_guard.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"

namespace fpkcheck::cli {
namespace {

using namespace std::chrono_literals;

// Time between the signal and the shutdown by the watchdog. The rest of the second is for the
// shutdown hooks, which write files on busy processors. A simulation ends after its current round,
// to keep its result: a round of 2e7 events takes longer than a second on few processors.
constexpr auto kToGiveUp = 300ms;
constexpr auto kToFinishEarly = 4000ms;

constexpr const char* kNothing = "nothing was written";

struct Ending {
  std::mutex mutex;  // guards the members below
  std::vector<const std::function<void()>*> rescues;
  std::string kept = kNothing;
  bool command_ended = false;
  std::condition_variable changed;
};

// Never destroyed: threads may still use the state while the process exits.
Ending& ending() {
  static Ending& one = *new Ending;
  return one;
}

std::atomic<bool> watched = false, end_claimed = false;
sem_t signal_came;

[[noreturn]] void wait_for_the_end() {
  while (true) pause();
}

// Not by stdio: another thread may hold its locks while it waits for a reader.
void say(const std::string& line) {
  const std::string text = (can_rewrite_a_line() ? "\r\033[K" : "") + line + '\n';
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

// Returns if the command has claimed the shutdown; the command then prints the message and joins
// this thread.
void end_the_process() {
  if (end_claimed) return;
  base::reserve_writes_for_this_thread();
  if (end_claimed.exchange(true)) return;
  std::vector<const std::function<void()>*> rescues;
  std::unique_lock lock(ending().mutex);
  rescues.swap(ending().rescues);
  lock.unlock();
  std::ranges::reverse(rescues);
  for (const auto* rescue : rescues) {
    try {
      (*rescue)();
    } catch (const std::exception& error) {
      note_kept(fmt::format("{} ({})", kNothing, error.what()));
    }
  }
  say("fpkcheck: " + stop_notice());
  _exit(stopped_exit_code(base::stop_signal()));
}

void watch() {
  while (sem_wait(&signal_came) != 0) continue;
  Ending& e = ending();
  std::unique_lock lock(e.mutex);
  const auto grace = on_interruption() == OnInterruption::finish_early ? kToFinishEarly : kToGiveUp;
  if (e.changed.wait_for(lock, grace, [&] { return e.command_ended; })) return;
  lock.unlock();
  end_the_process();
}

}  // namespace

Rescue::Rescue(std::function<void()> action) : action_(std::move(action)) {
  const std::lock_guard lock(ending().mutex);
  ending().rescues.push_back(&action_);
}

Rescue::~Rescue() {
  std::unique_lock lock(ending().mutex);
  if (std::erase(ending().rescues, &action_) > 0) return;
  lock.unlock();
  wait_for_the_end();  // the watchdog runs the hook: its data must stay alive until the exit
}

OutputDirectory::OutputDirectory(const std::optional<std::string>& out)
    : rescue_([this] { directory_ = {}; }) {
  if (!out) return;
  const base::WriteGuard in_hand;
  directory_ = results::prepare_output_directory(*out);
}

void note_kept(const std::string& what) {
  const std::lock_guard lock(ending().mutex);
  ending().kept = what;
}

std::string stop_notice() {
  const std::lock_guard lock(ending().mutex);
  return fmt::format("{}; {}", base::stop_signal() == SIGTERM ? "terminated" : "interrupted",
                     ending().kept);
}

Deadline::Deadline() {
  end_claimed = false;
  ending().command_ended = false;
  sem_init(&signal_came, 0, 0);
  watched = true;
  thread_ = std::thread(watch);
}

Deadline::~Deadline() {
  {
    const std::lock_guard lock(ending().mutex);
    ending().command_ended = true;
  }
  ending().changed.notify_all();
  watched = false;
  sem_post(&signal_came);
  thread_.join();
}

void wake_deadline() {
  if (watched) sem_post(&signal_came);
}

void claim_the_end() {
  if (watched && end_claimed.exchange(true)) wait_for_the_end();
}

}  // namespace fpkcheck::cli
