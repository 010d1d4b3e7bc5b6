#pragma once

#include <csignal>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "results/output_directory.hpp"

/// Shutdown of the program after SIGINT or SIGTERM within a second, or within five seconds if a
/// simulation returns its partial result. Long operations such as a matrix factorisation, a time
/// step of CVODE or a least-squares fit cannot be interrupted. The numerical solvers contain no
/// code for the shutdown after a signal. After a stop signal, a command usually ends by itself,
/// between two solutions or after a round of the simulation. If a command does not end soon enough
/// after a stop signal, the thread of the ShutdownWatchdog ends the process. The watchdog thread
/// first waits for file writes in progress (base/process/stop_request.hpp). Before the watchdog
/// thread ends the process without stack unwinding, the thread runs the registered actions
/// (ShutdownHook). ProcessExitBlocker, ShutdownHook and OutputDirectory leave the files on disk in
/// a consistent state.
namespace fpkcheck::cli {

/// Exception after SIGINT (Ctrl-C) or SIGTERM. exit_message() returns the message for the user.
struct InterruptedBySignal : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

enum class InterruptionPolicy {
  abort,        ///< the function throw_if_interrupted() throws InterruptedBySignal
  finish_early  ///< the solver polls base::stop_requested() and returns its partial result
};

/// Guard that installs signal handlers for the lifetime of the guard. The first SIGINT or SIGTERM
/// sets the stop request (base/process/stop_request.hpp), and a second signal ends the program at
/// once. Signals that the process ignored before (nohup) remain ignored.
class SignalHandlerGuard {
 public:
  SignalHandlerGuard();
  ~SignalHandlerGuard();
  SignalHandlerGuard(const SignalHandlerGuard&) = delete;
  SignalHandlerGuard& operator=(const SignalHandlerGuard&) = delete;

 private:
  struct SavedAction {
    int signal;
    struct sigaction action;
  };
  std::vector<SavedAction> saved_actions_;
};

/// Sets the reaction of the program to stop signals. The default policy is `abort`.
void set_interruption_policy(InterruptionPolicy policy);
InterruptionPolicy interruption_policy();

/// Throws the exception InterruptedBySignal after a stop signal. Progress functions of long
/// computations call throw_if_interrupted().
/// @throws InterruptedBySignal after SIGINT or SIGTERM, unless the policy is finish_early
void throw_if_interrupted();

/// Registers, for the lifetime of the ShutdownHook, an action that runs before a forced end of the
/// process. Before the ShutdownWatchdog ends the process, the watchdog runs the registered actions
/// in reverse order.
class ShutdownHook {
 public:
  explicit ShutdownHook(std::function<void()> action);
  ~ShutdownHook();
  ShutdownHook(const ShutdownHook&) = delete;
  ShutdownHook& operator=(const ShutdownHook&) = delete;

 private:
  std::function<void()> action_;
};

/// Output directory of the option --out, prepared by results::prepare_output_directory(). The
/// destructor or the ShutdownWatchdog removes the empty directories that an OutputDirectory
/// created. Without the option --out an OutputDirectory has no effect.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::optional<std::string>& out);

 private:
  results::OutputDirectoryLock directory_;
  ShutdownHook hook_;
};

/// Sets the part of exit_message() that states which results remain after a stop of the program.
/// The default is "nothing was written".
void set_exit_message(const std::string& message);
/// Returns the cause of the stop ("interrupted" or "terminated") and the text of
/// set_exit_message().
std::string exit_message();

/// Thread that ends the process after the first SIGINT or SIGTERM. At most one ShutdownWatchdog may
/// exist.
class ShutdownWatchdog {
 public:
  ShutdownWatchdog();
  ~ShutdownWatchdog();
  ShutdownWatchdog(const ShutdownWatchdog&) = delete;
  ShutdownWatchdog& operator=(const ShutdownWatchdog&) = delete;

 private:
  std::thread thread_;
};

/// Notifies an existing ShutdownWatchdog of a stop signal. The notification is async-signal-safe.
void notify_watchdog();

/// Reserves the end of the process after a stop signal for the calling thread. A command that ended
/// by itself after a signal calls claim_shutdown_for_this_thread() before the command prints
/// exit_message(). If the watchdog has already claimed the shutdown,
/// claim_shutdown_for_this_thread() does not return but waits for the exit of the process.
void claim_shutdown_for_this_thread();

}  // namespace fpkcheck::cli
