#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "methods/run_cases.hpp"
#include "report/text/text_layout.hpp"

namespace fpkcheck::cli {

/// Connects closed standard streams to /dev/null, since otherwise the next opened file would
/// receive the output of a closed stream. SIGPIPE is ignored, so that a closed pipe (`fpkcheck run
/// | head -1`) does not end the program before all files are written. The function
/// prepare_standard_streams() must be called before any file is opened.
void prepare_standard_streams();

/// Writes a text to standard output. A write error of print_output() does not stop the program;
/// run_program() finally reports the error.
void print_output(std::string_view text);

/// Writes the program's name and a message in one line to standard error, and ignores write errors.
void print_message(std::string_view message);

/// Returns the text format (width and colours) of standard output. The width of terminal texts is
/// the width of the terminal, limited to 80 .. 100 columns, or 100 columns without a terminal.
/// Colours are used on a terminal, unless NO_COLOR is set and not empty, or TERM is "dumb".
report::TerminalTextFormat terminal_format();

/// Returns the progress of a run as text: completed solutions, elapsed time, and the running method
/// with its completed fraction. Above a completed fraction of 2 %, the progress text includes the
/// estimated remaining time.
/// @param seconds time since the start of the run
/// @param method_seconds time since the start of the running method on its case
std::string progress_text(const methods::RunProgress& progress, double seconds,
                          double method_seconds);

/// Returns whether standard error is a terminal that accepts control sequences (TERM is not
/// `dumb`).
bool stderr_is_interactive();

/// Progress line on standard error. A ProgressLine prints nothing if `silent` is true or
/// stderr_is_interactive() is false.
class ProgressLine {
 public:
  explicit ProgressLine(bool silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @throws InterruptedBySignal after a stop signal (throw_if_interrupted()), even if no progress
  ///         line is printed
  void show_progress(const methods::RunProgress& progress);
  /// Erases the progress line; must be called before results are printed.
  void erase_line();

 private:
  bool is_visible_ = false;
  bool active_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// Start time of the computation of each case by each method; several methods may run in
  /// parallel.
  std::map<std::pair<std::string, std::string>, std::chrono::steady_clock::time_point> began_;
};

}  // namespace fpkcheck::cli
