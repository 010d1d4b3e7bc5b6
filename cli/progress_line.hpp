#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "methods/run_cases.hpp"

namespace fpkcheck::cli {

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
  /// @throws Interrupted if throw_if_interrupted() throws (interruption.hpp), also without output
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
