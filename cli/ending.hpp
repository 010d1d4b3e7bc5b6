#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "results/directory.hpp"

/// How a program that is told to stop comes to its end within a second, whatever it is doing.
///
/// Most of what takes long cannot be asked to stop: a factorisation, a step of CVODE, a fit. So
/// nothing in the solvers is asked. A command that can end by itself (between two solutions, after a
/// round of the simulation) does, and that is the usual way. Where it has not done so within a
/// fraction of a second, the thread of a Deadline ends the process beside it: it waits for files that
/// are half written (base/process/write_guard.hpp), does what the command left to be done (Rescue), and
/// leaves without unwinding anything. Memory and threads go with the process; what is left on disk
/// is what WriteGuard, Rescue and OutputDirectory look after.
namespace fpkcheck::cli {

/// Something to be done when the process is ended by another thread while this lives; the last made
/// is done first.
class Rescue {
 public:
  explicit Rescue(std::function<void()> action);
  ~Rescue();
  Rescue(const Rescue&) = delete;
  Rescue& operator=(const Rescue&) = delete;

 private:
  std::function<void()> action_;
};

/// The directory of --out, prepared (results::prepare_output_directory); what it made and nothing was put into
/// goes again, also when the process is ended by another thread. Without --out nothing.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::optional<std::string>& out);

 private:
  results::OutputDirectoryLock directory_;
  Rescue rescue_;
};

/// What became of the work when the program was told to stop, for the one line that it says then:
/// "nothing was written" until told otherwise.
void note_kept(const std::string& what);
/// That line.
std::string stop_notice();

/// While it lives, which is as long as the program runs, a first SIGINT or SIGTERM ends the process
/// within a second. One at most.
class Deadline {
 public:
  Deadline();
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  std::thread thread_;
};

/// Tells the deadline, if there is one, of a signal. May be called in a handler of signals.
void wake_deadline();

/// To be called by a command that was told to stop and has ended by itself, before it says so.
/// Returns unless the deadline came first; then waits for the end of the process.
void claim_the_end();

}  // namespace fpkcheck::cli
