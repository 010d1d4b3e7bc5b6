#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "methods/run_cases.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::cli {

/// Makes the standard streams safe to write to; call before any file is opened. A closed standard
/// stream is connected to /dev/null; otherwise the next opened file would get the descriptor of the
/// stream and receive the output. SIGPIPE is ignored, so that a closed pipe (`fpkcheck run | head
/// -1`) does not end the program before its files are written.
void prepare_standard_streams();

/// Writes to standard output. After a write error the program still writes its files, and
/// run_program reports the error at the end.
void print_output(std::string_view text);

/// Writes "fpkcheck: MESSAGE" to standard error, in one line. The function ignores write errors.
void print_message(std::string_view message);

/// Text format of standard output. The text width is the width of the terminal, limited to 80 ..
/// 100 columns, or 100 columns without a terminal. Output to a terminal has colours, unless
/// NO_COLOR is set and not empty, or TERM is "dumb".
report::TextFormat terminal_format();

/// Text of the progress of a run: number of completed solutions, elapsed time, the running method
/// with its completed fraction and, above a fraction of 2 %, an estimate of its remaining time.
/// @param seconds time since the start of the run
/// @param method_seconds time since the start of the running method on its case
std::string progress_text(const methods::RunProgress& progress, double seconds,
                          double method_seconds);

/// Whether standard error is a terminal that accepts control sequences (TERM is not `dumb`).
bool can_rewrite_line();

/// Progress line on standard error that is rewritten during a run. The class prints nothing if
/// `silent` is true or can_rewrite_line() is false.
class ProgressLine {
 public:
  explicit ProgressLine(bool silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Prints the progress.
  /// @throws Interrupted if throw_if_interrupted() throws (shutdown.hpp), also without output
  void rewrite(const methods::RunProgress& progress);
  /// Erases the progress line; must be called before results are printed.
  void erase();

 private:
  bool is_visible_ = false;
  bool active_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// Start time of each method on each case; several methods run in parallel.
  std::map<std::pair<std::string, std::string>, std::chrono::steady_clock::time_point> began_;
};

}  // namespace fpkcheck::cli
