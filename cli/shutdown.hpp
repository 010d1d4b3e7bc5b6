#pragma once

#include <csignal>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "results/output_directory.hpp"

/// Shutdown after SIGINT or SIGTERM within a second, whatever the program computes.
///
/// The longest computations cannot be interrupted: a matrix factorisation, a time step of CVODE, a
/// least-squares fit. Therefore the solvers contain no code for the shutdown. Usually a command
/// ends by itself, between two solutions or after a round of the simulation. If the command is
/// still running a fraction of a second after the signal, the thread of a ShutdownWatchdog ends the
/// process. The watchdog thread waits for the end of file writes in progress
/// (base/process/stop_request.hpp), runs the actions that the command registered (ShutdownHook),
/// and exits without stack unwinding. The operating system releases memory and threads;
/// ExitBlocker, ShutdownHook and OutputDirectory leave the files on disk in a consistent state.
namespace fpkcheck::cli {

/// Exception that is thrown after SIGINT (Ctrl-C) or SIGTERM. The message for the user is
/// exit_message() (shutdown.hpp).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Reaction of the program to the first SIGINT or SIGTERM.
enum class InterruptionPolicy {
  abort,        ///< throw_if_interrupted throws
  finish_early  ///< the solver polls base::stop_requested() and returns its result so far
};

/// Guard that installs signal handlers during its lifetime. The first SIGINT or SIGTERM sets the
/// stop request (base/process/stop_request.hpp); a second signal ends the program at once. Signals
/// that are ignored (nohup) stay ignored.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct SavedAction {
    int signal;
    struct sigaction action;
  };
  std::vector<SavedAction> saved_actions_;
};

/// Sets or returns the current reaction to signals. The default policy is `abort`.
void set_interruption_policy(InterruptionPolicy policy);
InterruptionPolicy interruption_policy();

/// Ends a computation after a signal. The progress functions of long computations call this
/// function.
/// @throws Interrupted after SIGINT or SIGTERM, unless the policy is finish_early
void throw_if_interrupted();

/// Registers an action during its own lifetime; the ShutdownWatchdog runs the registered actions
/// before it ends the process. The actions run in the reverse order of their registration.
class ShutdownHook {
 public:
  explicit ShutdownHook(std::function<void()> action);
  ~ShutdownHook();
  ShutdownHook(const ShutdownHook&) = delete;
  ShutdownHook& operator=(const ShutdownHook&) = delete;

 private:
  std::function<void()> action_;
};

/// Output directory of --out, prepared by results::prepare_output_directory. The destructor, or the
/// watchdog if it ends the process, removes the empty directories that the OutputDirectory made.
/// Without --out an OutputDirectory has no effect.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::optional<std::string>& out);

 private:
  results::OutputDirectoryLock directory_;
  ShutdownHook hook_;
};

/// Sets the second part of exit_message(), which states the results that remain after a stop of the
/// program. The default is "nothing was written".
void set_exit_message(const std::string& message);
/// Message of a stopped program: "interrupted; MESSAGE" or "terminated; MESSAGE".
std::string exit_message();

/// Thread that ends the process within a second after the first SIGINT or SIGTERM. The object lives
/// as long as the program runs; at most one object may exist.
class ShutdownWatchdog {
 public:
  ShutdownWatchdog();
  ~ShutdownWatchdog();
  ShutdownWatchdog(const ShutdownWatchdog&) = delete;
  ShutdownWatchdog& operator=(const ShutdownWatchdog&) = delete;

 private:
  std::thread thread_;
};

/// Notifies the ShutdownWatchdog, if an object exists, of a signal. Async-signal-safe.
void notify_watchdog();

/// Claims the shutdown for the calling thread. A command that ended by itself after a signal calls
/// this function before it prints exit_message(). If the watchdog has already claimed the shutdown,
/// the function does not return and waits for the exit of the process.
void claim_shutdown();

}  // namespace fpkcheck::cli
