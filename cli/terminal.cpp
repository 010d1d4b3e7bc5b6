#include "cli/terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "base/text/printable_text.hpp"
#include "cli/shutdown_after_signal.hpp"

namespace fpkcheck::cli {

void prepare_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The system call open() returns the lowest free file descriptor, which equals `stream`, since
    // all smaller descriptors are open.
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDWR) != stream) std::abort();
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void print_output(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void print_message(std::string_view message) {
  const std::string line = fmt::format("fpkcheck: {}\n", base::to_single_line(message));
  std::fwrite(line.data(), 1, line.size(), stderr);
}

namespace {

std::optional<std::size_t> terminal_width(int stream) {
  winsize size{};
  if (ioctl(stream, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

std::string duration_text(double seconds) {
  return seconds < 100 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace

bool stderr_is_interactive() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::string progress_text(const methods::RunProgress& progress, double seconds,
                          double method_seconds) {
  constexpr double kMinFractionForEstimate = 0.02;
  const double fraction = progress.fraction;
  std::string text = fmt::format("[{}/{}] {}  {} {}", progress.done, progress.total,
                                 duration_text(seconds), progress.case_name, progress.method);
  if (fraction > 0 && fraction < 1) text += fmt::format(" {:.0f} %", 100 * fraction);
  if (fraction > kMinFractionForEstimate && fraction < 1) {
    text += fmt::format(", {} left", duration_text(method_seconds * (1 - fraction) / fraction));
  }
  return progress.note.empty() ? text : text + "  " + progress.note;
}

ProgressLine::ProgressLine(bool silent) : active_(!silent && stderr_is_interactive()) {}

ProgressLine::~ProgressLine() { erase_line(); }

void ProgressLine::show_progress(const methods::RunProgress& progress) {
  throw_if_interrupted();
  if (!active_) return;
  const auto now = std::chrono::steady_clock::now();
  const auto began = began_.try_emplace({progress.case_name, progress.method}, now).first->second;
  const std::chrono::duration<double> elapsed = now - begin_, method_elapsed = now - began;
  // A progress line wider than the terminal would be wrapped, and a wrapped line cannot be erased.
  fmt::print(stderr, "\r\033[K{}",
             progress_text(progress, elapsed.count(), method_elapsed.count())
                 .substr(0, terminal_width(STDERR_FILENO).value_or(80) - 1));
  std::fflush(stderr);
  is_visible_ = true;
}

void ProgressLine::erase_line() {
  if (is_visible_) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  is_visible_ = false;
}

report::TerminalTextFormat terminal_format() {
  constexpr std::size_t kMinWidth = 80, kMaxWidth = 100;
  const auto is = [](const char* variable, auto condition) {
    const char* const value = std::getenv(variable);
    return value != nullptr && condition(std::string_view(value));
  };
  const bool plain = is("NO_COLOR", [](auto value) { return !value.empty(); }) ||
                     is("TERM", [](auto value) { return value == "dumb"; });
  return {std::clamp(terminal_width(STDOUT_FILENO).value_or(kMaxWidth), kMinWidth, kMaxWidth),
          isatty(STDOUT_FILENO) == 1 && !plain};
}

}  // namespace fpkcheck::cli
