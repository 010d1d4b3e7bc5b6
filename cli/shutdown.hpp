#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "results/directory.hpp"

/// Shutdown after SIGINT or SIGTERM within a second, whatever the program computes.
///
/// Most long computations cannot be interrupted: a factorisation, a step of CVODE, a fit. The
/// solvers therefore do not poll for signals. Normally a command ends by itself: between two
/// solutions, or after a round of the simulation. If the command has not ended within a fraction of
/// a second, the thread of a ShutdownWatchdog ends the process. The thread waits for files that are
/// being written (base/process/write_guard.hpp), runs the hooks of the command (ShutdownHook), and
/// exits without unwinding the stack. The operating system releases memory and threads; WriteGuard,
/// ShutdownHook and OutputDirectory keep the files on disk complete.
namespace fpkcheck::cli {

/// Action that the ShutdownWatchdog runs before it ends the process, while this object lives. Hooks
/// run in the reverse order of their construction.
class ShutdownHook {
 public:
  explicit ShutdownHook(std::function<void()> action);
  ~ShutdownHook();
  ShutdownHook(const ShutdownHook&) = delete;
  ShutdownHook& operator=(const ShutdownHook&) = delete;

 private:
  std::function<void()> action_;
};

/// The directory of --out, prepared by results::prepare_output_directory. Directories that were
/// created and stayed empty are removed, also when the watchdog ends the process. Does nothing
/// without --out.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::optional<std::string>& out);

 private:
  results::OutputDirectoryLock directory_;
  ShutdownHook hook_;
};

/// Sets the second part of exit_message(): the results that are kept when the program is stopped.
/// The default is "nothing was written".
void set_exit_message(const std::string& message);
/// The line that a stopped program prints: "interrupted; MESSAGE" or "terminated; MESSAGE".
std::string exit_message();

/// While this object lives (as long as the program runs), the first SIGINT or SIGTERM ends the
/// process within a second. At most one object may exist.
class ShutdownWatchdog {
 public:
  ShutdownWatchdog();
  ~ShutdownWatchdog();
  ShutdownWatchdog(const ShutdownWatchdog&) = delete;
  ShutdownWatchdog& operator=(const ShutdownWatchdog&) = delete;

 private:
  std::thread thread_;
};

/// Notifies the watchdog, if there is one, of a signal. Async-signal-safe.
void notify_watchdog();

/// Claims the shutdown for the caller: a command that ended by itself after a signal calls this
/// before it prints exit_message(). If the watchdog has claimed the shutdown first, this never
/// returns and waits for the exit of the process.
void claim_shutdown();

}  // namespace fpkcheck::cli
