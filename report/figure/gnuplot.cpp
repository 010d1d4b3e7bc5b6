#include "report/figure/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/process/stop_request.hpp"

extern char** environ;

namespace fpkcheck::report {
namespace {

[[noreturn]] void throw_system_error(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

using Clock = std::chrono::steady_clock;

/// A pipe that receives the standard output and standard error of a child process. The standard
/// input of the child process is empty.
class ChildProcessOutputPipe {
 public:
  ChildProcessOutputPipe() {
    // The ends of the pipe are closed on exec, since a child process that another thread starts
    // must not inherit the pipe.
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw_system_error(errno, "pipe");
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions_, ends_[0]);
    posix_spawn_file_actions_addclose(&actions_, ends_[1]);
  }
  ChildProcessOutputPipe(const ChildProcessOutputPipe&) = delete;
  ChildProcessOutputPipe& operator=(const ChildProcessOutputPipe&) = delete;
  ~ChildProcessOutputPipe() {
    posix_spawn_file_actions_destroy(&actions_);
    for (const int end : ends_) {
      if (end >= 0) close(end);
    }
  }

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

  /// Reads the output of a child process until its end, and returns the beginning of the output.
  /// The returned output of the child process is empty if the deadline passes or a stop is
  /// requested.
  std::optional<std::string> read_until_end(Clock::time_point deadline) {
    // Largest length of the returned gnuplot output, of which callers report the first line.
    constexpr std::size_t kMost = 10000;
    close(ends_[1]);  // read() returns the end of file only if all writers have closed the pipe
    ends_[1] = -1;
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
      constexpr int kMilliseconds = 50;  // interval of the checks of deadline and stop request
      if (base::stop_requested() || Clock::now() > deadline) return std::nullopt;
      pollfd end{.fd = ends_[0], .events = POLLIN, .revents = 0};
      const int ready = poll(&end, 1, kMilliseconds);
      if (ready == 0) continue;
      const ssize_t count = ready < 0 ? -1 : read(ends_[0], buffer.data(), buffer.size());
      if (count > 0) {
        text.append(buffer.data(), std::min(static_cast<std::size_t>(count), kMost - text.size()));
      } else if (count == 0 || errno != EINTR) {
        return text;
      }
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
  posix_spawn_file_actions_t actions_;
};

/// Spawn attributes that reset SIGPIPE to its default action. fpkcheck ignores SIGPIPE, and a child
/// process would inherit this setting.
class SigpipeResetAttributes {
 public:
  SigpipeResetAttributes() {
    sigset_t default_signals;
    sigemptyset(&default_signals);
    sigaddset(&default_signals, SIGPIPE);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigdefault(&attributes_, &default_signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  SigpipeResetAttributes(const SigpipeResetAttributes&) = delete;
  SigpipeResetAttributes& operator=(const SigpipeResetAttributes&) = delete;
  ~SigpipeResetAttributes() { posix_spawnattr_destroy(&attributes_); }

  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

/// @return the exit code of the child process, or -1 if a signal ended the process; nothing while
///         the process runs
std::optional<int> reap_child(pid_t child, int options) {
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(child, &status, options);
  } while (ended < 0 && errno == EINTR);
  if (ended < 0) throw_system_error(errno, "waitpid");
  if (ended == 0) return std::nullopt;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Waits for the exit of a child process that has closed its output.
/// @return the exit code of the process; nothing if the deadline passes or a stop is requested
std::optional<int> wait_for_exit(pid_t child, Clock::time_point deadline) {
  constexpr std::chrono::milliseconds kFirstPause(1), kLongestPause(20);
  for (auto pause = kFirstPause;; pause = std::min(2 * pause, kLongestPause)) {
    if (const auto exit_code = reap_child(child, WNOHANG)) return exit_code;
    if (base::stop_requested() || Clock::now() > deadline) return std::nullopt;
    std::this_thread::sleep_for(pause);
  }
}

// Returns pointers to texts, followed by a null pointer, as the C interface of posix_spawn
// requires.
std::vector<char*> null_terminated_pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_without_prefix(std::string_view prefix) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!std::string_view(*entry).starts_with(prefix)) all.emplace_back(*entry);
  }
  return all;
}

}  // namespace

GnuplotOutcome run_gnuplot(const std::string& program, const std::vector<std::string>& assignments,
                           const std::filesystem::path& script,
                           std::chrono::milliseconds time_limit) {
  std::string commands;
  for (const auto& assignment : assignments) commands += assignment + "; ";
  // The gnuplot process is started without a shell, so that paths need no quotes. The path of the
  // script is absolute, since gnuplot would run a file name that begins with '<' as a command.
  std::vector<std::string> arguments{program, "-d", "-e", commands,
                                     std::filesystem::absolute(script).string()};
  auto argv = null_terminated_pointers(arguments);
  auto environment = environment_without_prefix("GNUTERM=");
  auto envp = null_terminated_pointers(environment);

  ChildProcessOutputPipe error_pipe;
  const SigpipeResetAttributes signals;
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), error_pipe.actions(),
                                 signals.attributes(), argv.data(), envp.data());
  if (error == ENOENT || error == EACCES) return {false, -1, ""};
  if (error != 0) throw_system_error(error, "cannot start gnuplot");
  const auto deadline = Clock::now() + time_limit;
  auto message = error_pipe.read_until_end(deadline);
  const auto exit_code = message ? wait_for_exit(child, deadline) : std::nullopt;
  if (!exit_code) {
    kill(child, SIGKILL);
    reap_child(child, 0);
    return {true, -1,
            fmt::format("time limit of {} s exceeded",
                        std::chrono::duration<double>(time_limit).count())};
  }
  return {true, *exit_code, *std::move(message)};
}

std::string quote_for_gnuplot(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (std::iscntrl(static_cast<unsigned char>(c))) {
      // A line break within a gnuplot string would end the string, and gnuplot would run the next
      // line as a command.
      quoted += ' ';
    } else {
      quoted += c == '\'' ? "''" : std::string(1, c);
    }
  }
  return quoted + "'";
}

std::string escape_enhanced_text(const std::string& text) {
  constexpr std::string_view kMarks = "_^{}@&~\\";
  std::string escaped;
  for (const char c : text) {
    if (kMarks.find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace fpkcheck::report
